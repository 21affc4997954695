// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results go to standard output, everything else to standard error. A reader that
// went away (`| head`) is not an error; a full disk behind the output is one.
#pragma once

#include <stdexcept>
#include <string_view>

namespace keyblock::cli {

/// The command line cannot be carried out as given; reported on one line, exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Keeps a closed pipe, or a file that may grow no more, from ending the program.
void takeFailedWritesAsErrors();

/// Writes to standard output, at once.
void print(std::string_view text);

/// Writes to standard error, at once.
void printToError(std::string_view text);

/// Writes `error: …` on one line to standard error, line breaks within turned to spaces.
void printErrorLine(std::string_view message);

/// The system's error number if standard output took less than it was given, for another reason than a reader that
/// went away; else 0.
int outputFailure();

/// Whether standard error is a terminal.
bool errorIsTerminal();

/// Columns of the terminal behind standard error; 80 where it does not say.
int terminalWidth();

}  // namespace keyblock::cli
