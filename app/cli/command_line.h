// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts the command line arguments to a command with its options.
#pragma once

#include "app/cli/cli_commands.h"

#include <string>
#include <variant>

namespace keyblock::cli {

/// The text printed for `--help` or `--version`.
struct Answer {
    std::string text;
};

/// Reads the command line. \return a command, or the text for `--help` or `--version`. \throws UsageError
std::variant<Command, Answer> readCommandLine(int argc, const char* const* argv);

}  // namespace keyblock::cli
