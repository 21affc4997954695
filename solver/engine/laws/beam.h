// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steel shank between two nodes: a corotational beam with optional shear deformation.
//
// Relative to its current chord, a beam has only three strains: its elongation and the
// rotations φ1 and φ2 of its ends. Bending decouples into the pair
//     p1 = (φ1 − φ2)/√2  (constant moment)   stiffness 2EI/L
//     p2 = (φ1 + φ2)/√2  (constant shear)    stiffness 6EI/((1+b)L)
// with b = 12·E·I·k/(G·A·L²), so that every part of a bolt is a scalar spring. Expressed
// in the six end displacements, this is the modified Euler–Bernoulli matrix (unified bolt
// paper, eq. 12, with its misprints corrected: −EA/L couples the ends, EI appears in the
// rotational terms, and 1/(1+b) multiplies all bending terms).
#pragma once

#include "geometry/point.h"

#include <Eigen/Core>

namespace keyblock {

struct BeamSection {
    double area = 0.0;  // [m²]
    double secondMoment = 0.0;  // [m⁴]
    double youngsModulus = 0.0;  // [Pa]
    double shearModulus = 0.0;  // [Pa]
    double shearCoefficient = 4.0 / 3.0;  // k in the paper
    double density = 0.0;  // [kg/m³]
};

/// Parameter b = 12·E·I·k/(G·A·L²) of the modified beam element, or 0 if the element has no shear deformation.
double shearModifier(const BeamSection& section, double length, bool shears);

/// Stiffness matrix in local axes [N/m, N, N m] for the unknowns u1, w1, θ1, u2, w2, θ2: displacements along and normal
/// to the element and rotation, at ends 1 and 2.
Eigen::Matrix<double, 6, 6> beamStiffness(const BeamSection& section, double length, bool shears);

/// Translational mass lumped at each end: half of ρ·A·L [kg].
double lumpedMass(const BeamSection& section, double length);

/// Rotational inertia lumped at each end for dynamics: half of the element's mass times the square of a quarter of its
/// length [kg m²].
double lumpedInertia(const BeamSection& section, double length);

/// Positions of an element's ends, and their rotations relative to the straight unloaded element.
struct BeamPose {
    Point x1{0.0, 0.0}, x2{0.0, 0.0};  // [m]
    double theta1 = 0.0, theta2 = 0.0;  // [rad], not limited to one turn
};

/// Strains of a corotational beam, with the unit vectors needed for their gradients.
struct BeamStrains {
    double elongation = 0.0;  // current chord length minus initial length [m]
    double p1 = 0.0, p2 = 0.0;  // bending strains [rad]
    double length = 0.0;  // current chord length [m]
    Point along{1.0, 0.0}, across{0.0, 1.0};  // unit vectors along the chord and normal to it
};

/// Strains of an element at the given pose.
/// \param length0 the initial length [m]; \param angle0 the initial direction of the chord [rad].
BeamStrains beamStrains(const BeamPose& pose, double length0, double angle0);

/// End moments and shear force of an element.
struct BeamForces {
    double moment1 = 0.0, moment2 = 0.0;  // moments on the element's ends, counter-clockwise [N m]
    double shear = 0.0;  // shear force on the far side of a section, positive to the left of the axis [N]
};

/// Calculates the end moments and the shear force from the forces conjugate to p1 and p2 [N m] and the element length
/// [m].
BeamForces beamForces(double force1, double force2, double length);

}  // namespace keyblock
