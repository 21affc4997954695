// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/laws/beam.h"

#include <array>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

/// `angle` plus the whole turns that bring it nearest to zero. Most angles are near it already, and `std::remainder`
/// is slow.
double withoutTurns(double angle) {
    return std::abs(angle) <= std::numbers::pi ? angle : std::remainder(angle, 2.0 * std::numbers::pi);
}

}  // namespace

double shearModifier(const BeamSection& s, double length, bool shears) {
    if (!shears || s.shearModulus <= 0.0) return 0.0;
    return 12.0 * s.youngsModulus * s.secondMoment * s.shearCoefficient / (s.shearModulus * s.area * length * length);
}

Eigen::Matrix<double, 6, 6> beamStiffness(const BeamSection& s, double length, bool shears) {
    const double b = shearModifier(s, length, shears);
    const double axial = s.youngsModulus * s.area / length;
    const double bend = s.youngsModulus * s.secondMoment / ((1.0 + b) * length * length * length);
    const double l = length, l2 = length * length;
    Eigen::Matrix<double, 6, 6> k = Eigen::Matrix<double, 6, 6>::Zero();
    k(0, 0) = k(3, 3) = axial;
    k(0, 3) = k(3, 0) = -axial;
    const std::array<int, 4> at{1, 2, 4, 5};
    Eigen::Matrix4d bending;
    bending << 12, 6 * l, -12, 6 * l,                      //
        6 * l, (4 + b) * l2, -6 * l, (2 - b) * l2,         //
        -12, -6 * l, 12, -6 * l,                           //
        6 * l, (2 - b) * l2, -6 * l, (4 + b) * l2;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) k(at[i], at[j]) = bend * bending(i, j);
    return k;
}

double lumpedMass(const BeamSection& s, double length) { return 0.5 * s.density * s.area * length; }

double lumpedInertia(const BeamSection& s, double length) {
    return lumpedMass(s, length) * length * length / 16.0;
}

BeamStrains beamStrains(const BeamPose& pose, double length0, double angle0) {
    BeamStrains strains;
    const Point chord = pose.x2 - pose.x1;
    strains.length = chord.norm();
    strains.along = chord / strains.length;
    strains.across = turnLeft(strains.along);
    strains.elongation = strains.length - length0;
    const double turned = std::atan2(chord.y(), chord.x()) - angle0;
    const double phi1 = withoutTurns(pose.theta1 - turned);
    const double phi2 = withoutTurns(pose.theta2 - turned);
    strains.p1 = (phi1 - phi2) / std::numbers::sqrt2;
    strains.p2 = (phi1 + phi2) / std::numbers::sqrt2;
    return strains;
}

BeamForces beamForces(double force1, double force2, double length) {
    const double moment1 = (force1 + force2) / std::numbers::sqrt2;
    const double moment2 = (force2 - force1) / std::numbers::sqrt2;
    return {moment1, moment2, -(moment1 + moment2) / length};
}

}  // namespace keyblock
