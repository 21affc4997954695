// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The limits of a run. They are checked between and within steps and can do nothing
// but end the run: what was computed before has the same bytes as without them.
#pragma once

#include "solver/scene/scene.h"

#include <chrono>
#include <string>

namespace keyblock {

class RunLimit {
public:
    explicit RunLimit(const RunLimits& limits) : limits_(limits) {}

    /// True once as many steps are accepted, or as much time has gone by, as the scene allows.
    bool reached(long steps) const {
        return stepsReached(steps) || (limits_.wallTime && seconds() >= *limits_.wallTime);
    }

    /// Time for which the user paused the run does not count.
    void addPause(std::chrono::steady_clock::duration paused) { begun_ += paused; }

    /// Which limit it is. \pre reached(steps)
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
