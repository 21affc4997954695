// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limit analysis of a semicircular arch of rigid voussoirs on a tilted base: the
// least tilt over all mechanisms of four hinges, by virtual work. It shares no line
// with the program that it checks.
#pragma once

#include <array>

namespace keyblock::reference {

/// Equal voussoirs between the radii `mean` ± half of `thickness` [m], numbered from the right springing.
struct Arch {
    int voussoirs = 0;
    double mean = 0.0, thickness = 0.0;
};

/// A mechanism: four joints in rising order, each turning about its intrados or its extrados.
struct ArchCollapse {
    double tilt = 0.0;  // of the base, at which it begins [rad]
    std::array<int, 4> joints{};
    std::array<bool, 4> atIntrados{};
};

/// The mechanism that begins at the least tilt. Joints carry no tension and do not slide.
/// \pre the arch stands on a level base.
ArchCollapse collapseOf(const Arch& arch);

}  // namespace keyblock::reference
