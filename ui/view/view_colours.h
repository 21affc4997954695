// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of a section on the screen by their role, and drawing options. The window
// sets them from its theme.
#pragma once

#include "ui/picture/colour.h"

#include <vector>

namespace keyblock {

struct ViewColours {
    bool dark = false;  // use the colour maps for dark backgrounds
    Colour ground, opening, rock, joint, wall, ink, casing, accent, slipping, error;
    Colour quiet;  // bolts without values
    Colour bearing;  // forces of contacts that do not slide
    double jointOpacity = 0.7;
};

struct ViewStyle {
    bool drawing = false;  // show plain rock, not coloured by results
    double pixelRatio = 1.0;  // device pixels per device-independent pixel
    std::vector<int> selectedBolts;  // rows of the scene's bolts
};

}  // namespace keyblock
