// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alone in its file, so that a new version compiles nothing else.
#include "solver/files/program_version.h"

namespace keyblock {

std::string_view programVersion() { return KEYBLOCK_VERSION; }

}  // namespace keyblock
