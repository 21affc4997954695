// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One axis for all stages of a scene, computed or not. The width of a stage depends on
// its kind, and time is linear within a stage. Positions on the axis run from 0 to 1.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <vector>

namespace keyblock {

class TimeAxis {
public:
    struct Span {
        int stage = 0;
        double from = 0.0, to = 0.0;  // positions on the axis
        double duration = 1.0;  // duration of a dynamic stage [s]; 1 (pseudo-time) for a static stage
    };

    TimeAxis() = default;
    /// Makes each dynamic stage three times as wide as a static one.
    explicit TimeAxis(const Scene& scene);

    const std::vector<Span>& spans() const { return spans_; }
    bool isEmpty() const { return spans_.empty(); }
    /// Axis position of a time that is counted from the start of the stage; the end of the axis if the stage does not
    /// exist.
    double at(int stage, double time) const;

    struct Moment {
        int stage = 0;
        double time = 0.0;
    };
    /// Stage and time at the axis position `place`. A position outside 0 … 1 is treated as the nearest end of the axis.
    /// \pre there is at least one stage.
    Moment momentAt(double place) const;

private:
    std::vector<Span> spans_;
};

}  // namespace keyblock
