// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Uses plain stdio, which reports reliable error numbers; a stream reports only that
// it failed.
#include "app/cli/output.h"

#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>

namespace keyblock::cli {

namespace {

int firstFailure = 0;

}  // namespace

void takeFailedWritesAsErrors() {
    for (const int signal : {SIGPIPE, SIGXFSZ})
        ::signal(signal, SIG_IGN);
}

void print(std::string_view text) {
    if (firstFailure != 0)
        return;
    errno = 0;
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!written)
        firstFailure = errno != 0 ? errno : EIO;
}

void printToError(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void printErrorLine(std::string_view message) {
    std::string line = "error: " + std::string(message);
    std::replace_if(line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    printToError(line + '\n');
}

int outputFailure() { return firstFailure == EPIPE ? 0 : firstFailure; }

bool errorIsTerminal() { return ::isatty(STDERR_FILENO) == 1; }

int terminalWidth() {
    winsize size{};
    const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

}  // namespace keyblock::cli
