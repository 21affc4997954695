// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of `verify` that runs scenes to the limits of the method.
#pragma once

#include "app/cli/cli_commands.h"

namespace keyblock::cli {

ExitCode performExtremes(const VerifyOptions& options);

}  // namespace keyblock::cli
