// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the words after `keyblock` to a command.
#pragma once

#include "app/cli/cli_commands.h"

#include <string>
#include <variant>

namespace keyblock::cli {

/// The text printed for `--help` or `--version`.
struct Answer {
    std::string text;
};

/// Reads the command line. \throws UsageError
std::variant<Command, Answer> readCommandLine(int argc, const char* const* argv);

}  // namespace keyblock::cli
