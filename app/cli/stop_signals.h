// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ctrl+C or SIGTERM makes a run stop within one step and keep its results; a second
// signal ends the program immediately (the store remains intact).
#pragma once

#include <atomic>

namespace keyblock::cli {

/// Whether SIGTERM after a first signal ends the program. Job schedulers may send it several times.
enum class RepeatedTerm { Ends, Ignored };

/// While this object exists, the first Ctrl+C or SIGTERM sets `stop`. \pre no other object of this class exists, and
/// `stop` outlives this one.
class StopSignals {
public:
    explicit StopSignals(std::atomic<bool>& stop, RepeatedTerm repeated = RepeatedTerm::Ends);
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
};

}  // namespace keyblock::cli
