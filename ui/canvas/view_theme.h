// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of the window's theme for the section and its marks.
#pragma once

#include "ui/view/view_colours.h"

#include <QColor>

namespace keyblock {

struct Theme;

inline Colour colourOf(const QColor& colour) {
    return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
            static_cast<std::uint8_t>(colour.blue())};
}
inline QColor qtColour(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

ViewColours viewColoursOf(const Theme& theme, bool drawing);

}  // namespace keyblock
