// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In a file of its own, so that nothing else is recompiled for a new version.
#include "solver/files/program_version.h"

namespace keyblock {

std::string_view programVersion() { return KEYBLOCK_VERSION; }

}  // namespace keyblock
