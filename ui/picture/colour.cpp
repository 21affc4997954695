// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/colour.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

std::uint8_t between(std::uint8_t from, std::uint8_t to, double share) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
}

}  // namespace

const ColourMap& darkOf(const ColourMap& map) {
    if (map == slate) return slateDark;
    return map == ember ? emberDark : map;
}

Colour colourAt(const ColourMap& map, double share) {
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(map.size() - 1);
    const auto lower = std::min(static_cast<std::size_t>(place), map.size() - 2);
    const double rest = place - static_cast<double>(lower);
    const Colour &a = map[lower], &b = map[lower + 1];
    return {between(a.red, b.red, rest), between(a.green, b.green, rest), between(a.blue, b.blue, rest)};
}

}  // namespace keyblock
