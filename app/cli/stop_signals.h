// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ctrl+C or SIGTERM makes a run stop within one step and keep its results; a second
// signal ends the program immediately (the store remains intact).
#pragma once

#include <atomic>

namespace keyblock::cli {

/// For the lifetime of this object, the first Ctrl+C or SIGTERM sets `stop`. \pre there is only one such object at a
/// time, and `stop` outlives it.
class StopSignals {
public:
    explicit StopSignals(std::atomic<bool>& stop);
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
};

}  // namespace keyblock::cli
