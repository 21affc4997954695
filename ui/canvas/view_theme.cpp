// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/view_theme.h"

#include "ui/look/theme.h"

namespace keyblock {

ViewColours viewColoursOf(const Theme& theme, bool drawing) {
    const QColor joint = drawing ? theme.jointDrawing : theme.jointLine;
    ViewColours colours;
    colours.dark = theme.dark;
    colours.ground = colourOf(theme.canvas);
    colours.opening = colourOf(theme.opening);
    colours.rock = colourOf(theme.rock);
    colours.joint = colourOf(joint);
    colours.jointOpacity = joint.alphaF();
    colours.wall = colourOf(theme.wall);
    colours.ink = colourOf(theme.markInk);
    colours.casing = colourOf(theme.markCasing);
    colours.accent = colourOf(theme.accent);
    colours.slipping = colourOf(theme.slipping);
    colours.error = colourOf(theme.error);
    colours.quiet = colourOf(theme.text3);
    colours.bearing = (theme.dark ? slateDark : slate).back();
    return colours;
}

}  // namespace keyblock
