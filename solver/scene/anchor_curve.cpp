// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/anchor_curve.h"

namespace keyblock {

Anchor withCurve(const Anchor& anchor) {
    if (anchor.law != AnchorLaw::PeakResidual || anchor.softeningSlip <= 0.0 || !anchor.strength ||
        anchor.stiffness <= 0.0)
        return anchor;
    const double atPeak = *anchor.strength / anchor.stiffness;
    Anchor curved = anchor;
    curved.law = AnchorLaw::Curve;
    curved.curve = {{0.0, 0.0}, {atPeak, *anchor.strength}, {atPeak + anchor.softeningSlip, anchor.residual}};
    curved.after = anchor.residual > 0.0 ? AfterCurve::Last : AfterCurve::Zero;
    curved.strength.reset();
    return curved;
}

}  // namespace keyblock
