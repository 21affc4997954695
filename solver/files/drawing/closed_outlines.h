// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines in drawings are often several lines and arcs that meet end to end.
#pragma once

#include "solver/files/drawing/drawing.h"

#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct ClosedOutline {
    std::vector<Point> points;  // the first not repeated
    std::vector<std::size_t> lines;  // that it is made of, as indices
};

struct ClosedOutlines {
    std::vector<ClosedOutline> outlines;  // in the order of their first lines
    std::vector<std::size_t> open;  // lines that belong to none
};

/// Joins lines whose ends lie within `tolerance` of each other to closed outlines; closed lines are outlines already.
/// An end continues with the first line, in their order, that is there and not used.
ClosedOutlines closeOutlines(std::span<const DrawnLine> lines, double tolerance);

}  // namespace keyblock
