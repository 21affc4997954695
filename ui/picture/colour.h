// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colour maps of results. Slate (cool) colours blocks and Ember (hot) colours bolts, so
// that the two can be told apart; Tide is for quantities with both signs. Lightness
// changes in nearly equal steps, so that a map remains readable in greyscale.
#pragma once

#include <array>
#include <cstdint>

namespace keyblock {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;

    bool operator==(const Colour&) const = default;
};

constexpr Colour rgb(std::uint32_t hex) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8 & 0xff),
            static_cast<std::uint8_t>(hex & 0xff)};
}

/// Nine colours for values at equal intervals, from the lowest value to the highest.
using ColourMap = std::array<Colour, 9>;

inline constexpr ColourMap slate{rgb(0xF3EEE6), rgb(0xD2DED4), rgb(0xB4CBC4), rgb(0x97B6B5), rgb(0x7CA1A7),
                                 rgb(0x628C99), rgb(0x4B768B), rgb(0x37607D), rgb(0x264A6E)};
inline constexpr ColourMap ember{rgb(0xEAB745), rgb(0xE59C0E), rgb(0xDF8100), rgb(0xD66500), rgb(0xC84A00),
                                 rgb(0xB63100), rgb(0xA01B16), rgb(0x870723), rgb(0x6D0027)};
inline constexpr ColourMap tide{rgb(0x0B6EAC), rgb(0x508DBE), rgb(0x82ACD0), rgb(0xB4CCE2), rgb(0xF5EDE7),
                                rgb(0xDFC3B0), rgb(0xCA9C7D), rgb(0xB5764B), rgb(0x9F5104)};

// Slate and Ember for a dark background: high values stand out against it as well.
inline constexpr ColourMap slateDark{rgb(0x1F2631), rgb(0x263647), rgb(0x2C475C), rgb(0x325970), rgb(0x3A6B82),
                                     rgb(0x477E92), rgb(0x58919F), rgb(0x6FA3AB), rgb(0x89B4B7)};
inline constexpr ColourMap emberDark{rgb(0x7C2440), rgb(0x9B2E3E), rgb(0xB73D35), rgb(0xCE5328), rgb(0xE06F1D),
                                     rgb(0xEA8D2B), rgb(0xEFAC4E), rgb(0xF2CA79), rgb(0xF5E5A8)};

/// The version of a map for dark backgrounds. The map Tide is the same on light and dark backgrounds.
const ColourMap& darkOf(const ColourMap& map);

/// The colour at the fraction `share` of the range, interpolated linearly between the colours of the map. Fractions
/// below 0 or above 1 give the colour of the nearest end.
Colour colourAt(const ColourMap& map, double share);

}  // namespace keyblock
