// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steel shank between two nodes: a corotational beam that may shear.
//
// Measured along the current chord, a beam has three strains only: its
// elongation and the rotations φ1, φ2 of its ends against the chord. Bending
// decouples into the pair
//     p1 = (φ1 − φ2)/√2  (constant moment)   stiffness 2EI/L
//     p2 = (φ1 + φ2)/√2  (constant shear)    stiffness 6EI/((1+b)L)
// with b = 12·E·I·k/(G·A·L²), so that every part of a bolt is a scalar spring.
// Written out in the six end displacements this is the modified
// Euler–Bernoulli matrix (unified bolt paper, eq. 12, with its misprints put
// right: −EA/L couples the ends, EI stands in the rotations, 1/(1+b) before all).
#pragma once

#include "geometry/point.h"

#include <Eigen/Core>

namespace keyblock {

struct BeamSection {
    double area = 0.0;  // [m²]
    double secondMoment = 0.0;  // [m⁴]
    double youngsModulus = 0.0;  // [Pa]
    double shearModulus = 0.0;  // [Pa]
    double shearCoefficient = 4.0 / 3.0;  // the paper's k
    double density = 0.0;  // [kg/m³]
};

/// b of the modified beam; 0 where the element does not shear.
double shearModifier(const BeamSection& section, double length, bool shears);

/// Stiffness in local axes, order u1, w1, θ1, u2, w2, θ2 [N/m, N, N m].
Eigen::Matrix<double, 6, 6> beamStiffness(const BeamSection& section, double length, bool shears);

/// Translational mass that each end takes: half of ρ·A·L [kg].
double lumpedMass(const BeamSection& section, double length);

/// Small positive inertia of each end's rotation in dynamics: its half of the mass on a quarter of the length [kg m²].
double lumpedInertia(const BeamSection& section, double length);

/// Where an element is: its ends and their rotations since it was straight and unloaded.
struct BeamPose {
    Point x1{0.0, 0.0}, x2{0.0, 0.0};  // [m]
    double theta1 = 0.0, theta2 = 0.0;  // [rad], may pass any number of turns
};

/// What a corotational beam feels, with the directions that turn displacements into it.
struct BeamStrains {
    double elongation = 0.0;  // [m] current chord less first length
    double p1 = 0.0, p2 = 0.0;  // [rad] bending pair
    double length = 0.0;  // [m] of the current chord
    Point along{1.0, 0.0}, across{0.0, 1.0};  // unit vectors of the chord and of its normal
};

/// \param length0 first length [m]; \param angle0 direction of the first chord [rad].
BeamStrains beamStrains(const BeamPose& pose, double length0, double angle0);

/// End moments and shear force from the forces of the bending pair [N m].
struct BeamForces {
    double moment1 = 0.0, moment2 = 0.0;  // [N m] on the element's ends, counter-clockwise
    double shear = 0.0;  // [N] on the far side of a section, to the left of the axis
};
BeamForces beamForces(double force1, double force2, double length);

}  // namespace keyblock
