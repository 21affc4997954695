// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A signal handler may access only lock-free atomics and call only a few functions.
// Those that end the program in the default way are among them.
#include "app/cli/stop_signals.h"

#include <signal.h>

#include <cassert>

namespace keyblock::cli {

namespace {

static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free);

std::atomic<std::atomic<bool>*> stopFlag{nullptr};
std::atomic<bool> ignoresRepeatedTerm{false};

extern "C" void askToStop(int signal) {
    std::atomic<bool>* flag = stopFlag.load();
    if (flag && !flag->exchange(true))
        return;
    if (flag && signal == SIGTERM && ignoresRepeatedTerm) return;
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

}  // namespace

StopSignals::StopSignals(std::atomic<bool>& stop, RepeatedTerm repeated) {
    assert(!stopFlag.load());
    stopFlag = &stop;
    ignoresRepeatedTerm = repeated == RepeatedTerm::Ignored;
    struct sigaction action {};
    action.sa_handler = askToStop;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM})
        ::sigaction(signal, &action, nullptr);
}

StopSignals::~StopSignals() {
    for (const int signal : {SIGINT, SIGTERM})
        ::signal(signal, SIG_DFL);
    stopFlag = nullptr;
}

}  // namespace keyblock::cli
