// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects the ticks of a colour bar whose labels fit, on paper and on screen.
#pragma once

#include "ui/picture/section/legend.h"

#include <functional>
#include <string>
#include <vector>

namespace keyblock {

struct TickLabel {
    double place = 0.0, middle = 0.0;  // tick and centre of its label, from the left edge of the area
    std::string text;
};

struct TickRoom {
    double from = 0.0, to = 0.0;  // ends of the bar within that area
    double width = 0.0;  // of the area, within which all labels stay
    double gap = 0.0;  // smallest gap between two labels
    std::function<double(const std::string&)> widthOf;
};

/// Labels of all ticks if they fit. Otherwise labels of every second tick only, or of every third, and so on, until
/// they fit. The tick at zero is always labelled.
std::vector<TickLabel> tickLabels(const LegendBar& bar, const TickRoom& room);

}  // namespace keyblock
