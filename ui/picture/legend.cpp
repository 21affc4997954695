// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/legend.h"

namespace keyblock {

Colour LegendBar::colourOf(double shown) const {
    return colourAt(*map, shareOf(shown));
}

}  // namespace keyblock
