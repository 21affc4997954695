// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One axis for all stages of a scene, done and to come: each stage has room by its
// kind, and within it time runs evenly. Places are shares of the whole, 0 … 1.
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
    /// Dynamic stages have three times the room of static ones.
    explicit TimeAxis(const Scene& scene);

    const std::vector<Span>& spans() const { return spans_; }
    bool isEmpty() const { return spans_.empty(); }
    /// Place of a moment; that of the axis' end for a stage that is not there.
    double at(int stage, double time) const;

    struct Moment {
        int stage = 0;
        double time = 0.0;
    };
    /// The moment at a place; the nearest end outside 0 … 1. \pre there is a stage.
    Moment momentAt(double place) const;

private:
    std::vector<Span> spans_;
};

}  // namespace keyblock
