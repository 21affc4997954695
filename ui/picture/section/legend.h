// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Legend of a quantity shown by colours: title, unit, range, ticks, sign convention. By
// default the range spans all values of all frames, so that figures can be compared.
// Values outside the range get the end colours, and the bar indicates this.
#pragma once

#include "ui/picture/colour.h"
#include "ui/picture/scale_choice.h"
#include "ui/picture/section/contact_lines.h"
#include "ui/picture/ticks.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct LegendBar {
    std::string quantity;  // name of the quantity
    std::string title;
    std::string unit;
    const ColourMap* map = nullptr;
    ValueRange range;  // range of the colours, in the display unit
    ValueRange reach;  // range of all values in all frames, in the display unit
    ScaleChoice scale;  // the choice from which the range follows
    Ticks ticks;
    bool goesBelow = false, goesAbove = false;  // values beyond this end of the range exist and have the end colour
    std::vector<std::string> notes;
    std::string convention;  // sign convention; empty: none
    std::string dashed;  // meaning of dashed bolts, "compression" or "negative"; empty: no dashes
    std::optional<ValueRange> now;  // range of the frame shown, in the display unit
    std::vector<std::pair<double, std::string>> limits;  // capacities within the range, with their names

    /// Colour of the value `shown` [display unit] on a light or a dark background.
    Colour colourOf(double shown, bool dark = false) const;
    /// Positions along the bar, as fractions of the range, and their colours. A position at which the colour jumps is
    /// listed twice, with the colours on both sides.
    std::vector<std::pair<double, Colour>> stops(bool dark) const;
    /// True if a bolt element with this value is drawn as a dashed line.
    bool isDashed(double shown) const;
    /// True if the range excludes extreme values, as chosen by the user.
    bool clips() const { return scale.clips && scale.of != ScaleOf::Own && (goesBelow || goesAbove); }
    /// The colour map for a light or a dark background.
    const ColourMap& mapOn(bool dark) const { return dark ? darkOf(*map) : *map; }
    /// Position of a value in the range as a fraction: 0 at the lower end, 1 at the upper end.
    double shareOf(double shown) const { return (shown - range.low) / (range.high - range.low); }
};

/// Legends for the blocks and the bolts of a section, and the scale of its contact forces. A legend is null if no
/// quantity is shown or the quantity has no values in any frame; the scale is null if contact forces are not shown.
struct SectionLegends {
    std::optional<LegendBar> blocks, bolts;
    std::optional<ContactScale> contacts;
};

}  // namespace keyblock
