// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend of a coloured quantity: title, unit, range, ticks, sign convention. By
// default the range spans all values of all frames, so that pictures can be compared.
// Values outside the range get the end colours, and the bar says so.
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
    ScaleChoice scale;  // choice that gave the range
    Ticks ticks;
    bool goesBelow = false, goesAbove = false;  // values outside the range have the end colours
    std::vector<std::string> notes;
    std::string convention;  // meaning of a positive value; empty: none
    std::string dashed;  // meaning of dashes on the bars: compression, or another negative value; empty: there are none
    std::optional<ValueRange> now;  // of the frame, in the unit shown
    std::vector<std::pair<double, std::string>> limits;  // capacities within the range, named

    /// Colour of a value, on a light or a dark background.
    Colour colourOf(double shown, bool dark = false) const;
    /// Colours along the bar, each with its fraction of the range; a step is two colours at one fraction.
    std::vector<std::pair<double, Colour>> stops(bool dark) const;
    /// Whether a value is drawn with dashes.
    bool isDashed(double shown) const;
    /// Whether the user's choice excludes extreme values from the range.
    bool clips() const { return scale.clips && scale.of != ScaleOf::Own && (goesBelow || goesAbove); }
    /// The colours for the background of the picture.
    const ColourMap& mapOn(bool dark) const { return dark ? darkOf(*map) : *map; }
    /// Position of a value between the ends of the range: 0 … 1 within it.
    double shareOf(double shown) const { return (shown - range.low) / (range.high - range.low); }
};

/// Legends of the blocks and the bolts of a section; none for a quantity without values in any frame.
struct SectionLegends {
    std::optional<LegendBar> blocks, bolts;
    std::optional<ContactScale> contacts;
};

}  // namespace keyblock
