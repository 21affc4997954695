// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An independent calculation of a grouted bar that is drawn out of a joint: the
// continuous bar, N' = q(s) and s' = ε(N), integrated from its free end. It has no
// nodes and shares no line with the program that it checks.
#pragma once

#include "tests/verify/reference/bar.h"

namespace keyblock::reference {

/// A bond that softens: stiffness [N/m²] up to its peak, then straight down to its residual over `slip` [N/m, m].
struct SofteningBond {
    double stiffness = 0.0, peak = 0.0, residual = 0.0, slip = 0.0;
};

/// Half of a bar across a joint: embedded over `length` [m], from a free end to the joint.
struct EmbeddedBar {
    double length = 0.0, area = 0.0;
    Curve steel;  // strain, stress [Pa]
    SofteningBond bond;
};

/// Force at the joint [N] when the bar has been drawn out by `slip` there [m], without a turning back on the way.
double forceAtSlip(const EmbeddedBar& bar, double slip);

/// How far it is drawn out at the joint [m] under `force` [N]. \pre the force rises with the slip up to there.
double slipAtForce(const EmbeddedBar& bar, double force);

}  // namespace keyblock::reference
