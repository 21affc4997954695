// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A handler may touch nothing but a lock-free atomic.
#include "app/cli/stop_signals.h"

#include <signal.h>

namespace keyblock::cli {

namespace {

static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free);

std::atomic<std::atomic<bool>*> stopFlag{nullptr};

extern "C" void askToStop(int) {
    if (std::atomic<bool>* flag = stopFlag.load())
        flag->store(true);
}

}  // namespace

StopSignals::StopSignals(std::atomic<bool>& stop) {
    stopFlag = &stop;
    struct sigaction action {};
    action.sa_handler = askToStop;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM})
        ::sigaction(signal, &action, nullptr);
}

StopSignals::~StopSignals() {
    for (const int signal : {SIGINT, SIGTERM})
        ::signal(signal, SIG_DFL);
    stopFlag = nullptr;
}

}  // namespace keyblock::cli
