// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a coloured quantity means: title, unit, range, ticks, sign convention. Unless
// the user wants another, the range holds all values of all frames, so that pictures
// can be compared. Values outside the range take the end colours, and the bar says so.
#pragma once

#include "ui/picture/colour.h"
#include "ui/picture/contact_lines.h"
#include "ui/picture/scale_choice.h"
#include "ui/picture/ticks.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct LegendBar {
    std::string quantity;  // its name
    std::string title;
    std::string unit;
    const ColourMap* map = nullptr;
    ValueRange range;  // in the unit shown
    ValueRange reach;  // of all values in all frames, in the unit shown
    ScaleChoice scale;  // that led to the range
    Ticks ticks;
    bool goesBelow = false, goesAbove = false;  // values outside the range take the end colours
    std::vector<std::string> notes;
    std::string convention;  // what a positive value means; empty: nothing to tell
    std::string dashed;  // what dashes on the bars mean: compression, or another negative value; empty: there are none
    std::optional<ValueRange> now;  // of the frame, in the unit shown
    std::vector<std::pair<double, std::string>> limits;  // capacities within the range, named

    /// Of a value, on the light or the dark ground.
    Colour colourOf(double shown, bool dark = false) const;
    /// Colours along the bar, each with its share of the range; steps are pairs at one share.
    std::vector<std::pair<double, Colour>> stops(bool dark) const;
    /// True of a value that is drawn with dashes.
    bool isDashed(double shown) const;
    /// True where extreme values are left out of the range, as the user wants it.
    bool clips() const { return scale.clips && scale.of != ScaleOf::Own && (goesBelow || goesAbove); }
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
