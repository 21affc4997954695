// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a coloured quantity means: title, unit, range, ticks, sign convention. The
// range is the same in every frame of a run, so that two pictures can be compared;
// a few hundredths of the rock's area, where slivers carry what nothing else does,
// take the end colours and the bar says so.
#pragma once

#include "ui/picture/colour.h"
#include "ui/picture/contact_lines.h"
#include "ui/picture/ticks.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct LegendBar {
    std::string title;
    std::string unit;
    const ColourMap* map = nullptr;
    ValueRange range;  // in the unit shown
    Ticks ticks;
    bool goesBelow = false, goesAbove = false;  // values outside the range take the end colours
    std::vector<std::string> notes;
    std::string convention;  // what a positive value means; empty: nothing to tell
    std::optional<ValueRange> now;  // of the frame, in the unit shown
    std::vector<std::pair<double, std::string>> limits;  // capacities within the range, named

    Colour colourOf(double shown) const;
    /// The colours on the ground of the picture.
    const ColourMap& mapOn(bool dark) const { return dark ? darkOf(*map) : *map; }
    /// Where a value lies between the ends of the range: 0 … 1 within it.
    double shareOf(double shown) const { return (shown - range.low) / (range.high - range.low); }
};

/// Of the blocks and the bolts of a section; none of a quantity that no frame has a value of.
struct SectionLegends {
    std::optional<LegendBar> blocks, bolts;
    std::optional<ContactScale> contacts;
};

}  // namespace keyblock
