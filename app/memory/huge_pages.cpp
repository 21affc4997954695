// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of jemalloc, which the programs link. A factor and the rows of the links do not
// fit into the caches, and with pages of 4 KB the processor also has to look up their
// addresses in memory. Where the system leaves the choice to the program, as Debian does,
// huge pages are asked for. MALLOC_CONF overrides this.

// read by jemalloc when the program starts; its name and type are fixed there
extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "thp:always";
}
