// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The colours of a section on the screen by their roles, and how it is drawn. The
// window sets them from its theme.
#pragma once

#include "ui/picture/colour.h"

#include <vector>

namespace keyblock {

struct ViewColours {
    bool dark = false;  // which colour maps are used
    Colour ground, opening, rock, joint, wall, ink, casing, accent, slipping, error;
    Colour quiet;  // bolts without values
    Colour bearing;  // contacts that do not slide
    double jointOpacity = 0.7;
};

struct ViewStyle {
    bool drawing = false;  // plain rock; false: coloured by results where the picture has any
    double pixelRatio = 1.0;  // device pixels per device-independent pixel
    std::vector<int> selectedBolts;  // rows of the scene's bolts
};

}  // namespace keyblock
