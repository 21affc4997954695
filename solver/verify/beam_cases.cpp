// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The beam element of the bolt by itself, assembled here with the functions
// that the engine uses.
#include "solver/engine/laws/beam.h"
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/scenes.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

/// Round bar of 20 mm diameter, E = 200 GPa, G = 80 GPa.
BeamSection bar() {
    BeamSection section;
    section.area = barArea();
    section.secondMoment = std::numbers::pi * std::pow(0.02, 4) / 64.0;
    section.youngsModulus = 200e9;
    section.shearModulus = 80e9;
    section.density = 7850.0;
    return section;
}

Eigen::MatrixXd assembled(double length, int divisions, bool shears) {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * divisions + 3, 3 * divisions + 3);
    for (int e = 0; e < divisions; ++e) k.block<6, 6>(3 * e, 3 * e) += beamStiffness(bar(), length / divisions, shears);
    return k;
}

/// Deflection at the free end of a clamped bar of 0.5 m under a force of 1 N at that end [m].
double cantileverDeflection(int divisions, bool shears) {
    const Eigen::MatrixXd k = assembled(0.5, divisions, shears).bottomRightCorner(3 * divisions, 3 * divisions);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * divisions);
    load(3 * divisions - 2) = 1.0;
    return k.llt().solve(load)(3 * divisions - 2);
}

/// The deflection is PL³/3EI = 26.5258 µm; with shear deformation it is PL³/3EI + k·PL/GA = 26.5523 µm.
std::vector<CaseResult> beamPatch() {
    Checks checks("beam patch");
    const BeamSection s = bar();
    const double length = 0.5, bending = std::pow(length, 3) / (3.0 * s.youngsModulus * s.secondMoment);
    const double shear = s.shearCoefficient * length / (s.shearModulus * s.area);
    for (const int divisions : {1, 2, 7, 20}) {
        const std::string with = std::to_string(divisions) + " divisions";
        checks.relative("deflection, " + with + " [m]", cantileverDeflection(divisions, false), bending, 1e-6);
        checks.relative("with shear, " + with + " [m]", cantileverDeflection(divisions, true), bending + shear, 1e-6);
    }
    const Eigen::MatrixXd k = assembled(length, 1, true);
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
    checks.absolute("modes without energy", static_cast<double>((values.array() < 1e-9 * values(5)).count()), 3.0, 0.0);
    BeamPose turned;
    turned.x1 = {3.0, -1.0};
    turned.x2 = {3.0, -0.5};
    turned.theta1 = turned.theta2 = 0.5 * std::numbers::pi;
    const BeamStrains strains = beamStrains(turned, length, 0.0);
    checks.absolute("strains after a quarter turn",
                    std::abs(strains.elongation) / length + std::abs(strains.p1) + std::abs(strains.p2), 0.0, 1e-12);
    return checks.take();
}

/// First natural frequency of a bar of 2 m that is fixed at one end, with lumped masses: c/4L = 630.93 Hz.
std::vector<CaseResult> barVibration() {
    Checks checks("bar vibration");
    const int divisions = 60;
    const double length = 2.0;
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(divisions, divisions);
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(divisions);
    const Eigen::MatrixXd all = assembled(length, divisions, false);
    for (int i = 0; i < divisions; ++i)
        for (int j = 0; j < divisions; ++j) k(i, j) = all(3 * i + 3, 3 * j + 3);
    for (int e = 0; e < divisions; ++e) {
        const double half = lumpedMass(bar(), length / divisions);
        if (e > 0) mass(e - 1) += half;
        mass(e) += half;
    }
    const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = root.asDiagonal() * k * root.asDiagonal();
    const double lowest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()(0);
    checks.relative("first frequency [Hz]", std::sqrt(lowest) / (2.0 * std::numbers::pi), 630.93, 1e-3);
    return checks.take();
}

}  // namespace

std::vector<Case> beamCases() {
    return {{"beam patch", "A clamped bar of 20 mm under a force at its end.", beamPatch},
            {"bar vibration", "Lengthwise vibration of a bar of 60 elements.", barVibration}};
}

}  // namespace keyblock
