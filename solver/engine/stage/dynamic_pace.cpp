// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/dynamic_pace.h"

#include <algorithm>

namespace keyblock {
namespace {

constexpr double cutFactor = 0.3, growth = 2.0;
constexpr double shorter = 0.9;  // of a step that failed: the last one, if it was so short, is tried again
constexpr int mostEqualSteps = 127;

}  // namespace

double cutStep(DynamicPace& pace, double dt) {
    const bool grew = pace.last > cutFactor * dt && pace.last < shorter * dt;
    pace.dt = grew ? pace.last : cutFactor * dt;
    pace.equalSteps = pace.afterCut;
    pace.afterCut = 2 * std::min(pace.afterCut, mostEqualSteps / 2) + 1;
    return pace.dt;
}

void lengthenStep(DynamicPace& pace, double dt, double longest) {
    pace.last = dt;
    if (pace.equalSteps > 0) {
        --pace.equalSteps;
        return;
    }
    if (dt >= longest && pace.afterCut > 0) --pace.afterCut;
    pace.dt = std::min(growth * std::max(pace.dt, dt), longest);
}

double later(double time, double dt, double end, double& roundedUp) {
    if (dt == end - time) return end;
    const double step = dt - roundedUp;
    const double sum = time + step;
    roundedUp = (sum - time) - step;
    return sum;
}

}  // namespace keyblock
