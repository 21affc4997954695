// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The limits of a run. They are checked between and within steps and can only end the
// run: everything computed before is identical, byte for byte, to a run without limits.
#pragma once

#include "solver/scene/scene.h"

#include <chrono>
#include <string>

namespace keyblock {

class RunLimit {
public:
    explicit RunLimit(const RunLimits& limits) : limits_(limits) {}

    /// True once the run has reached the scene's limit on accepted steps or on wall-clock time.
    bool reached(long steps) const {
        return stepsReached(steps) || (limits_.wallTime && seconds() >= *limits_.wallTime);
    }

    /// Excludes a pause by the user from the wall-clock time.
    void addPause(std::chrono::steady_clock::duration paused) { begun_ += paused; }

    /// Message stating which limit the run has reached.
    /// \pre `reached(steps)`
    std::string message(long steps) const;

private:
    bool stepsReached(long steps) const { return limits_.steps && steps >= *limits_.steps; }
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    }

    RunLimits limits_;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace keyblock
