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
/// the program. If the program was started with standard output or error closed, keeps files that it opens from taking
/// their place; writing to standard output, also as `/dev/stdout`, is then an error.
void takeFailedWritesAsErrors();

/// Writes `text` to standard output and flushes the stream. Characters that control a terminal, other than line feeds,
/// are shown as escapes (`visibleLines`).
void print(std::string_view text);

/// Writes `text` to standard error, in the same way.
void printToError(std::string_view text);

/// Writes `error: …` to standard error on one line; line feeds in the message are shown as escapes too.
void printErrorLine(std::string_view message);

/// Replaces the last line of the terminal to which standard error is connected; it has no line feed at its end.
void replaceErrorLine(std::string_view text);

/// System error number of the first failed write to standard output; 0 if no write failed or the first failure was due
/// to a closed pipe.
int outputFailure();

/// True if the reader of standard output has closed its pipe, so that the results of a command would be lost.
bool readerIsGone();

/// True if standard error is a terminal.
bool errorIsTerminal();

/// Width in characters of the terminal to which standard error is connected; 80 if the width is unknown.
int terminalWidth();

}  // namespace keyblock::cli
