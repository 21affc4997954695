// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The force diagram of one bolt, a band next to it, in units of the paper or in pixels:
// the same on both.
#pragma once

#include "ui/picture/section.h"

#include <vector>

namespace keyblock {

struct RibbonShape {
    Point across{0.0, 1.0};  // unit vector from the bolt to the diagram
    std::vector<Point> base;  // line of zero, a point per node
    std::vector<Point> outline;  // along the values from end to end of the line of zero, in steps
    std::vector<Point> feet, tips;  // middle of each element on the line of zero and at its value
    std::vector<std::vector<Point>> limits;  // lines in steps
    Point limitFrom{0.0, 0.0}, limitTo{0.0, 0.0};  // level of the largest limit along the bolt, if there is one
    Point peak{0.0, 0.0};
};

/// \param nodes of the bolt on paper, y downwards; `gap` is the distance of the diagram from the bolt, `room` the size
/// of its scale.
RibbonShape ribbonShape(const Ribbon& ribbon, const std::vector<double>& values, const std::vector<Point>& nodes,
                        double gap, double room);

/// The unit of the values, without "per bolt".
std::string ribbonUnit(const LegendBar& legend);

}  // namespace keyblock
