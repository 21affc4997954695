// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results are written to standard output, everything else to standard error. A closed
// pipe (`| head`) is not an error, but a full disk behind the output is.
#pragma once

#include <stdexcept>
#include <string_view>

namespace keyblock::cli {

/// Invalid command line. The message is printed on one line, and the program ends with exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Ignores SIGPIPE and SIGXFSZ, so that a closed pipe or a file at its size limit makes writes fail instead of ending
/// the program.
void takeFailedWritesAsErrors();

/// Writes `text` to standard output and flushes the stream.
void print(std::string_view text);

/// Writes `text` to standard error and flushes the stream.
void printToError(std::string_view text);

/// Writes `error: …` to standard error on one line; line breaks in the message are replaced by spaces.
void printErrorLine(std::string_view message);

/// System error number of the first failed write to standard output; 0 if no write failed or the first failure was due
/// to a closed pipe.
int outputFailure();

/// True if standard error is a terminal.
bool errorIsTerminal();

/// Width in characters of the terminal to which standard error is connected; 80 if the width is unknown.
int terminalWidth();

}  // namespace keyblock::cli
