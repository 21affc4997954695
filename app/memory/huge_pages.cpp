// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of jemalloc, which the programs link. A factor and the rows of the links do not
// fit into the caches, and with pages of 4 KB the processor also has to look up their
// addresses in memory. Huge pages are therefore asked for, which takes effect where the
// system leaves the choice to programs. The environment variable MALLOC_CONF overrides this.

// read by jemalloc when the program starts; its name and type are fixed there
extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "thp:always";
}
