// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One axis for all stages of a scene, computed or not: the width of each stage depends
// on its kind, and time is linear within it. Positions are fractions of the whole, 0 …
// 1.
#pragma once

#include "solver/scene/scene.h"

#include <optional>
#include <vector>

namespace keyblock {

class TimeAxis {
public:
    struct Span {
        int stage = 0;
        double from = 0.0, to = 0.0;  // on the axis
        double duration = 1.0;  // [s] of a dynamic stage; pseudo-time 1 of a static one
    };

    TimeAxis() = default;
    /// Dynamic stages are three times as wide as static ones.
    explicit TimeAxis(const Scene& scene);

    const std::vector<Span>& spans() const { return spans_; }
    bool isEmpty() const { return spans_.empty(); }
    /// Position of a time; the end of the axis for a stage that does not exist.
    double at(int stage, double time) const;

    struct Moment {
        int stage = 0;
        double time = 0.0;
    };
    /// The time at a position; outside 0 … 1 the nearest end. \pre there is a stage.
    Moment momentAt(double place) const;

private:
    std::vector<Span> spans_;
};

}  // namespace keyblock
