// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve of force over strain with elastic unloading: the steel's backbone
// and the force–slip curve of an anchor are the same law.
//
// Loading follows the curve, unloading its first slope; hardening is isotropic
// and compression mirrors tension. With the plastic strain p and the
// accumulated plastic strain a, the yield force is the curve's force at the
// point whose plastic part is a. The step's response is the usual return
// mapping; for a curve that never falls it has a convex potential.
#pragma once

#include <utility>
#include <vector>

namespace keyblock {

/// Curve from the origin, strain rising. A piece flatter than 1e-7 of the first slope uses that slope,
/// and so does the force past the last point.
struct Backbone {
    double modulus = 0.0;  // slope of the first piece
    std::vector<double> plastic;  // accumulated plastic strain at each yield point, from 0
    std::vector<double> force;  // yield force there
    double lastStrain = 0.0;  // strain of the last point

    /// \pre at least the origin and one point with positive strain and force.
    static Backbone of(const std::vector<std::pair<double, double>>& curve, double strainScale = 1.0,
                       double forceScale = 1.0);

    /// The same curve with every yield force times `factor`; first slope and rupture strain stay.
    Backbone strengthened(double factor) const;
};

struct BackboneState {
    double plastic = 0.0;  // plastic strain, signed
    double accumulated = 0.0;  // sum of its magnitudes

    bool operator==(const BackboneState&) const = default;
};

struct BackboneResponse {
    double force = 0.0;
    double tangent = 0.0;
    BackboneState state;
    double plasticWork = 0.0;  // of this step
};

/// Force at `strain` from a committed state.
BackboneResponse respond(const Backbone& backbone, const BackboneState& state, double strain);

/// Mean of the force along the strain from `from`, where the state was committed, to `to`.
double averageForce(const Backbone& backbone, const BackboneState& state, double from, double to);

/// Yield force at the state's accumulated plastic strain.
double yieldForce(const Backbone& backbone, double accumulated);

}  // namespace keyblock
