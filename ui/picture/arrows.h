// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Directions over a section: principal stresses as crosses in the blocks, arrows of
// displacement and velocity. All have one scale, which the legend shows.
#pragma once

#include "solver/results/results.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

enum class ArrowKind { StressCrosses, Displacements, Velocities };

/// The kind named by the user: stress-crosses, displacement-arrows, velocity-arrows; none for other words.
std::optional<ArrowKind> arrowKindOf(std::string_view word);

/// Those words, in the order of `ArrowKind`.
std::span<const std::string_view> arrowWords();

enum class ArrowShape { Arrow, Compression, Tension };

/// One of them: a bar centred at its position, or an arrow from its tail.
struct ArrowMark {
    ArrowShape shape = ArrowShape::Arrow;
    Point place{0.0, 0.0};  // [m]
    Point value{0.0, 0.0};  // direction and size, in the unit shown
};

struct ArrowField {
    std::string title, unit;
    std::vector<std::string> notes;
    std::vector<ArrowMark> marks;
    double largest = 0.0;  // size, in the unit shown
};

/// Length on paper of a unit of the field [mm].
double arrowScale(const ArrowField& field);

/// Of a frame; `places` are the blocks' centroids as drawn [m], one row per block.
ArrowField arrowField(ArrowKind kind, const Frame& frame, const std::vector<Point>& places);

}  // namespace keyblock
