// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ctrl+C and SIGTERM ask a run to stop within one step and keep its results; asked
// a second time, they end the program at once (the store stays whole).
#pragma once

#include <atomic>

namespace keyblock::cli {

/// While it lives, the signals set `stop`. One at a time; `stop` must outlive it.
class StopSignals {
public:
    explicit StopSignals(std::atomic<bool>& stop);
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
};

}  // namespace keyblock::cli
