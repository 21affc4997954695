// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Uses plain stdio, which reports reliable error numbers; a stream reports only that
// it failed.
#include "app/cli/output.h"

#include "solver/scene/visible_text.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

namespace keyblock::cli {

namespace {

int firstFailure = 0;

void writeToError(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace

namespace {

/// Fills the numbers of closed standard descriptors with sockets, which cannot be opened as files.
void reserveStandardDescriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
        if (descriptor == STDOUT_FILENO) firstFailure = EBADF;
        ::socket(AF_UNIX, SOCK_STREAM, 0);  // takes the lowest free number, which is this one
    }
}

}  // namespace

void takeFailedWritesAsErrors() {
    reserveStandardDescriptors();
    for (const int signal : {SIGPIPE, SIGXFSZ})
        ::signal(signal, SIG_IGN);
}

void print(std::string_view text) {
    if (firstFailure != 0)
        return;
    const std::string shown = visibleLines(text);
    errno = 0;
    const bool written = std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size() && std::fflush(stdout) == 0;
    if (!written)
        firstFailure = errno != 0 ? errno : EIO;
}

void printToError(std::string_view text) { writeToError(visibleLines(text)); }

void printErrorLine(std::string_view message) { writeToError("error: " + visibleText(message) + '\n'); }

void replaceErrorLine(std::string_view text) { writeToError("\r\033[K" + visibleText(text)); }

int outputFailure() { return firstFailure == EPIPE ? 0 : firstFailure; }

bool readerIsGone() {
    pollfd output{STDOUT_FILENO, 0, 0};
    return firstFailure == EPIPE || (::poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0);
}

bool errorIsTerminal() { return ::isatty(STDERR_FILENO) == 1; }

int terminalWidth() {
    winsize size{};
    const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

}  // namespace keyblock::cli
