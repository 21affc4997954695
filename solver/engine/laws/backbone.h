// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A force–strain curve with elastic unloading. The stress–strain curve of steel and the
// force–slip curve of an anchor use the same law.
//
// Loading follows the curve, and unloading follows its initial slope. Hardening is
// isotropic, and compression mirrors tension. The yield force at an accumulated plastic
// strain a is the force at the point of the curve whose plastic strain is a. The response
// over a step is the usual return mapping; it has a convex potential if the curve never
// descends.
#pragma once

#include <utility>
#include <vector>

namespace keyblock {

/// Piecewise linear curve that starts at the origin, with increasing strain. A piece flatter than 1e-7 times the
/// initial slope is given that minimum slope, as is the continuation beyond the last point.
struct Backbone {
    double modulus = 0.0;  // slope of the first piece
    std::vector<double> plastic;  // accumulated plastic strain at each yield point, starting at 0
    std::vector<double> force;  // yield force at each yield point
    double lastStrain = 0.0;  // strain of the last point

    /// Curve through the given (strain, force) points, with both coordinates scaled.
    /// \pre `curve` contains at least the origin and one point with positive strain and force.
    static Backbone of(const std::vector<std::pair<double, double>>& curve, double strainScale = 1.0,
                       double forceScale = 1.0);

    /// Copy of the curve with all yield forces multiplied by `factor`; initial slope and rupture strain are unchanged.
    Backbone strengthened(double factor) const;
};

struct BackboneState {
    double plastic = 0.0;  // plastic strain, signed
    double accumulated = 0.0;  // accumulated magnitude of plastic strain

    bool operator==(const BackboneState&) const = default;
};

struct BackboneResponse {
    double force = 0.0;
    double tangent = 0.0;
    BackboneState state;
    double plasticWork = 0.0;  // plastic work over this step
};

/// Response at `strain`, starting from the accepted state `state`.
BackboneResponse respond(const Backbone& backbone, const BackboneState& state, double strain);

/// Mean force while the strain changes from `from` to `to`.
/// \param state the accepted state at the strain `from`
double averageForce(const Backbone& backbone, const BackboneState& state, double from, double to);

/// Yield force at the accumulated plastic strain `accumulated`.
double yieldForce(const Backbone& backbone, double accumulated);

}  // namespace keyblock
