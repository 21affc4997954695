// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/anchor_curve.h"

namespace keyblock {

namespace {

bool softens(const Anchor& anchor) {
    return rowOf(anchor.law).hasResidual && anchor.softeningSlip > 0.0 && anchor.strength && anchor.stiffness > 0.0;
}

/// Force–slip curve that falls from the peak to the residual over the softening slip.
Table softeningCurve(const Anchor& anchor) {
    const double atPeak = *anchor.strength / anchor.stiffness;
    return {{0.0, 0.0}, {atPeak, *anchor.strength}, {atPeak + anchor.softeningSlip, anchor.residual}};
}

}  // namespace

Anchor withCurve(const Anchor& anchor) {
    if (!softens(anchor)) return anchor;
    Anchor curved = anchor;
    curved.law = AnchorLaw::Curve;
    curved.curve = softeningCurve(anchor);
    curved.after = curved.curve.back().second > 0.0 ? AfterCurve::Last : AfterCurve::Zero;
    curved.strength.reset();
    return curved;
}

}  // namespace keyblock
