// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joins lines to closed outlines, because outlines in drawings often consist of
// several lines and arcs that meet end to end.
#pragma once

#include "solver/files/drawing/drawing.h"

#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct ClosedOutline {
    std::vector<Point> points;  // the first point is not repeated
    std::vector<std::size_t> lines;  // indices of the lines that it consists of
};

struct ClosedOutlines {
    std::vector<ClosedOutline> outlines;  // in the order of their first lines
    std::vector<std::size_t> open;  // indices of the lines that belong to no outline
};

/// Joins lines into closed outlines. Lines are joined where their ends lie within `tolerance` of each other. If several
/// lines meet at an end, the first of them in `lines` that is not used yet is taken. Each closed line is an outline of
/// its own.
ClosedOutlines closeOutlines(std::span<const DrawnLine> lines, double tolerance);

}  // namespace keyblock
