// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geometry of the force diagram of one bolt, drawn as a band next to the bolt. The
// units are those of the drawing, millimetres or pixels.
#pragma once

#include "ui/picture/section/section.h"

#include <vector>

namespace keyblock {

struct RibbonShape {
    Point across{0.0, 1.0};  // unit vector from the bolt to the diagram
    std::vector<Point> base;  // zero line, one point per node
    std::vector<Point> outline;  // stepped line of the values, from one end of the zero line to the other
    std::vector<Point> feet, tips;  // points at the middle of each element: on the zero line, and at its value
    std::vector<std::vector<Point>> limits;  // stepped lines of the limit
    Point limitFrom{0.0, 0.0}, limitTo{0.0, 0.0};  // ends of the line at the largest limit, if any
    Point peak{0.0, 0.0};  // tip of the element with the largest magnitude
};

/// Geometry of the force diagram.
/// \param values one per element. \param nodes nodes of the bolt as drawn, y downwards.
/// \param gap distance between bolt and diagram. \param room width of the diagram at the value `ribbon.scale`.
RibbonShape ribbonShape(const Ribbon& ribbon, const std::vector<double>& values, const std::vector<Point>& nodes,
                        double gap, double room);

/// Unit of the values, without "per bolt".
std::string ribbonUnit(const LegendBar& legend);

}  // namespace keyblock
