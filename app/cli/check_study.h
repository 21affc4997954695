// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `check` for a study file.
#pragma once

#include "app/cli/cli_commands.h"

namespace keyblock::cli {

/// Lists the problems of a study and of its scene, and the number of its cases.
ExitCode checkStudyFile(const CheckOptions& options);

}  // namespace keyblock::cli
