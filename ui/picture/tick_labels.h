// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses the ticks of a legend's bar whose numbers fit, on paper and on the screen.
#pragma once

#include "ui/picture/legend.h"

#include <functional>
#include <string>
#include <vector>

namespace keyblock {

struct TickLabel {
    double place = 0.0, middle = 0.0;  // from the bar's left end; a label stays within its ends
    std::string text;
};

struct TickRoom {
    double from = 0.0, to = 0.0;  // ends of the bar within the width
    double width = 0.0;
    double gap = 0.0;  // between two labels
    std::function<double(const std::string&)> widthOf;
};

/// All ticks if their labels fit, else every second one, and so on; zero stays.
std::vector<TickLabel> tickLabels(const LegendBar& bar, const TickRoom& room);

}  // namespace keyblock
