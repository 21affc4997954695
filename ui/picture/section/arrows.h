// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors drawn over a section: principal stresses as crosses in the blocks, and arrows
// of displacement or velocity. All vectors of a field have the same scale, which the
// legend shows.
#pragma once

#include "solver/results/results.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

enum class ArrowKind { StressCrosses, Displacements, Velocities };

/// The kind named by a word that the user typed: stress-crosses, displacement-arrows or velocity-arrows. Null for any
/// other word.
std::optional<ArrowKind> arrowKindOf(std::string_view word);

/// The words that `arrowKindOf` accepts, in the order of `ArrowKind`.
std::span<const std::string_view> arrowWords();

enum class ArrowShape { Arrow, Compression, Tension };

/// One vector of a field: an arrow that starts at `place`, or one bar of a stress cross, centred at `place`.
struct ArrowMark {
    ArrowShape shape = ArrowShape::Arrow;
    Point place{0.0, 0.0};  // [m]
    Point value{0.0, 0.0};  // direction and magnitude, in the display unit
};

struct ArrowField {
    std::string title, unit;
    std::vector<std::string> notes;
    std::vector<ArrowMark> marks;
    double largest = 0.0;  // largest magnitude, in the display unit
};

/// Length on paper [mm] per display unit of the field; 0 if all vectors are zero.
double arrowScale(const ArrowField& field);

/// Arrows or crosses for all blocks of a frame.
/// \param places centroids of the blocks as drawn [m], one for each block of the frame, in the same order.
ArrowField arrowField(ArrowKind kind, const Frame& frame, const std::vector<Point>& places);

}  // namespace keyblock
