// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verify/reference/bolts.h"

#include <algorithm>
#include <cmath>

namespace keyblock::reference {

const Curve textSteel{{0.0023, 490e6}, {0.021, 500e6}, {0.05, 560e6}, {0.09, 605e6}, {0.13, 625e6}, {0.16, 630e6}};
const Curve tableSteel{{0.0024, 509e6}, {0.021, 519e6}, {0.06, 585e6}, {0.11, 630e6}, {0.16, 651e6}, {0.24, 651e6}};

std::vector<double> evenNodes(double from, double to, int divisions) {
    std::vector<double> s;
    for (int i = 0; i <= divisions; ++i) s.push_back(from + (to - from) * i / divisions);
    return s;
}

void anchorEveryNode(BarProblem& problem, const Curve& curve, std::optional<double> peak, double residual) {
    for (std::size_t i = 0; i < problem.s.size(); ++i) {
        const double x = problem.s[i];
        if (std::abs(x - 1.0) < 1e-6) continue;
        problem.springs.push_back(
            {static_cast<int>(i), x < 1.0 ? Side::Fixed : Side::Moving, curve, peak, residual});
    }
}

void addPlate(BarProblem& problem, double stiffness, std::optional<double> strength) {
    problem.springs.push_back(
        {static_cast<int>(problem.s.size()) - 1, Side::Moving, {{1.0, stiffness}}, strength, 0.0, true, false});
}

void makeRockElastic(BarProblem& problem, double youngsModulus) {
    problem.blockStiffness = youngsModulus;
    problem.blockCentre = 1.5;
    problem.openingAt = 1.001;
}

BarProblem paperRebar(double youngsModulus, double peak, Mesh mesh) {
    BarProblem p;
    p.s = mesh == Mesh::JointInElement ? evenNodes(1.0 / 60.0, 2.0 - 1.0 / 60.0, 59) : evenNodes(0.0, 2.0, 60);
    p.area = barArea;
    p.steel = {{1.0, youngsModulus}};
    anchorEveryNode(p, {{1.0, 84.78e6}}, peak, 2.24e3);
    return p;
}

BarProblem elasticRebar(double springStiffness, double plateStiffness) {
    BarProblem p;
    p.s = evenNodes(0.0, 2.0, 60);
    p.area = barArea;
    p.steel = {{1.0, 212.08e9}};
    anchorEveryNode(p, {{1.0, springStiffness}}, std::nullopt, 0.0);
    addPlate(p, plateStiffness, std::nullopt);
    return p;
}

BarProblem paperDBolt(const Curve& steel, bool plate) {
    BarProblem p;
    p.s = evenNodes(0.0, 2.0, 60);
    p.area = barArea;
    p.steel = steel;
    p.unbreakable = false;
    for (const int node : {3, 13, 37, 54})
        p.springs.push_back({node, node < 30 ? Side::Fixed : Side::Moving, {{1.0, 84.78e6}}, std::nullopt, 0.0});
    if (plate) addPlate(p, 1e9, std::nullopt);
    return p;
}

BarProblem shearLag(int perSide, double plateStiffness) {
    BarProblem p;
    const double h = 1.0 / perSide;
    p.s = evenNodes(0.5 * h, 2.0 - 0.5 * h, 2 * perSide - 1);
    p.area = barArea;
    p.steel = {{1.0, 200e9}};
    anchorEveryNode(p, {{1.0, 254.34e6 * h}}, std::nullopt, 0.0);
    if (plateStiffness > 0.0) addPlate(p, plateStiffness, std::nullopt);
    return p;
}

BarProblem shearLagByLength(int divisions, double plateStiffness) {
    BarProblem p;
    const double h = 2.0 / divisions;
    p.s = evenNodes(0.0, 2.0, divisions);
    p.area = barArea;
    p.steel = {{1.0, 200e9}};
    anchorEveryNode(p, {{1.0, 254.34e6 * h}}, std::nullopt, 0.0);
    for (BarSpring& spring : p.springs)
        if (spring.node == 0 || spring.node == divisions) spring.curve[0].second *= 0.5;
    if (plateStiffness > 0.0) addPlate(p, plateStiffness, std::nullopt);
    return p;
}

BarProblem boltAcross(double joint, double length, int divisions, double area, const Curve& steel) {
    BarProblem p;
    p.s = evenNodes(0.0, length, divisions);
    p.area = area;
    p.steel = steel;
    p.blockStiffness = rockStiffness * (length - joint);
    p.blockCentre = 0.5 * (joint + length);
    p.openingAt = joint + 0.001;
    return p;
}

void anchorByLength(BarProblem& problem, double joint, double from, double to, const BarSpring& perMetre) {
    const double h = problem.s[1] - problem.s[0];
    for (std::size_t i = 0; i < problem.s.size(); ++i) {
        const double x = problem.s[i];
        if (std::abs(x - joint) < 1e-6) continue;
        const Side side = x < joint ? Side::Fixed : Side::Moving;
        const double low = std::max({x - 0.5 * h, from, side == Side::Moving ? joint : 0.0});
        const double high = std::min({x + 0.5 * h, to, side == Side::Fixed ? joint : problem.s.back()});
        if (high - low < 1e-9) continue;
        BarSpring spring = perMetre;
        spring.node = static_cast<int>(i);
        spring.side = side;
        for (auto& point : spring.curve) point.second *= high - low;
        if (spring.peak) *spring.peak *= high - low;
        spring.residual *= high - low;
        problem.springs.push_back(spring);
    }
}

}  // namespace keyblock::reference
