// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the in-situ stress from depth and K0 or from principal stresses, and writes
// it to the scene in one edit.
#pragma once

#include "ui/edit/edit.h"

namespace keyblock {

/// In-situ stress that increases with depth: the vertical stress is the overburden stress, and the horizontal stress is
/// K0 times the vertical stress.
struct DepthStress {
    double surfaceY = 0.0;  // elevation of the ground surface [m]
    double unitWeight = 0.0;  // of the overburden [N/m³]
    double k0 = 1.0;  // ratio of horizontal to vertical stress
};

/// Uniform in-situ stress, compression positive.
struct PrincipalStresses {
    double major = 0.0, minor = 0.0;  // σ1 and σ3 in the plane of the section [Pa]
    double angle = 0.0;  // direction of σ1, counter-clockwise from the x axis [°]
};

/// Sets an in-situ stress that increases with depth. Its reference elevation is the mid-height of the rock. Refused if
/// there is no rock, if rock lies above the ground surface, if the unit weight is not positive, or if K0 is negative.
Edit withDepthStress(const Scene& scene, const DepthStress& stress);

/// Sets a uniform in-situ stress. Refused if σ1 < σ3.
Edit withPrincipalStresses(const Scene& scene, const PrincipalStresses& stress);

/// Suggested input for `withDepthStress`. If the scene's in-situ stress increases with depth, its values are suggested.
/// Otherwise the ground surface is at the top of the rock, the unit weight is that of the first material, and K0 is 1.
DepthStress suggestedDepthStress(const Scene& scene);

/// Principal stresses of the scene's in-situ stress; its gradient is ignored.
PrincipalStresses principalStressesOf(const Scene& scene);

}  // namespace keyblock
