// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In-situ stress from depth and K0 or from principal stresses, written into the
// fields of the scene in one edit.
#pragma once

#include "ui/edit/edit.h"

namespace keyblock {

/// Vertical stress by the weight of the rock above, horizontal stress by a ratio to it.
struct DepthStress {
    double surfaceY = 0.0;  // elevation of the ground surface [m]
    double unitWeight = 0.0;  // of the rock above [N/m³]
    double k0 = 1.0;  // horizontal over vertical stress
};

/// Uniform, compression positive.
struct PrincipalStresses {
    double major = 0.0, minor = 0.0;  // σ1, σ3 in the plane [Pa]
    double angle = 0.0;  // of σ1 from the x axis, counter-clockwise [°]
};

/// Stress that increases with depth, given at mid-height of the rock. Refused: rock without size or partly above the
/// surface, a unit weight or ratio below zero.
Edit withDepthStress(const Scene& scene, const DepthStress& stress);

/// Refused: σ1 below σ3.
Edit withPrincipalStresses(const Scene& scene, const PrincipalStresses& stress);

/// Initial values: the surface at the upper edge of the rock, the unit weight of its first material.
DepthStress suggestedDepthStress(const Scene& scene);

/// From the stress of the scene, without its gradient.
PrincipalStresses principalStressesOf(const Scene& scene);

}  // namespace keyblock
