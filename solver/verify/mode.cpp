// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/mode.h"

#include "solver/run/run.h"
#include "solver/verify/scenes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

namespace keyblock {

namespace {

constexpr double modeModulus = 60e6, modeDensity = 2700.0, firstStress = 100.0;

double radiusOf(const Eigen::MatrixXd& matrix) { return matrix.eigenvalues().cwiseAbs().maxCoeff(); }

/// The matrix of one step for (u, Δt·v, Δt²·a) of u″ = −η²·u − 2ζη·u′ with Δt = 1. Damping acts on the mean velocity of
/// the step. Under generalized-α, it acts on the velocity at the point of the step at which forces are evaluated.
Eigen::Matrix3d stepMatrix(const ModeSetting& s) {
    const double k = s.eta * s.eta, c = 2.0 * (s.massShare + s.stiffnessShare) * s.eta;
    Eigen::Matrix3d step = Eigen::Matrix3d::Zero();
    if (s.scheme == Integration::GeneralizedAlpha) {
        const double r = s.rhoInf, am = (2 * r - 1) / (r + 1), af = r / (r + 1), g = 0.5 - am + af, b = 1 / ((r + 1) * (r + 1));
        // (1 − am)·a⁺ + am·a + c·[(1 − af)·v⁺ + af·v] + k·[(1 − af)·u⁺ + af·u] = 0 with Newmark's u⁺ and v⁺ substituted
        const double whole = (1 - am) + c * (1 - af) * g + k * (1 - af) * b;
        const Eigen::RowVector3d a(-k / whole, -(c + k * (1 - af)) / whole,
                                   -(am + c * (1 - af) * (1 - g) + k * (1 - af) * (0.5 - b)) / whole);
        step.row(0) = Eigen::RowVector3d(1, 1, 0.5 - b) + b * a;
        step.row(1) = Eigen::RowVector3d(0, 1, 1 - g) + g * a;
        step.row(2) = a;
        return step;
    }
    const bool euler = s.scheme == Integration::BackwardEuler;
    const double inertia = euler ? 1.0 : 2.0, share = s.scheme == Integration::Newmark ? 0.5 : 1.0;
    // for the displacement D of the step: inertia·(D − v) + c·D + k·(u + share·D) = 0
    const Eigen::RowVector3d d = Eigen::RowVector3d(-k, inertia, 0) / (inertia + c + share * k);
    step.row(0) = Eigen::RowVector3d(1, 0, 0) + d;
    step.row(1) = inertia * d - (euler ? 0.0 : 1.0) * Eigen::RowVector3d(0, 1, 0);
    return step;
}

}  // namespace

std::vector<double> modeSeries(const ModeSetting& setting) {
    const double frequency = std::sqrt(12.0 * modeModulus / modeDensity), step = setting.eta / frequency;
    Scene scene = emptyScene(modeModulus, 0.0, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    scene.blocks[0].initialStress = {firstStress, 0.0, 0.0};
    scene.analysis.damping = {2.0 * setting.massShare * frequency, 2.0 * setting.stiffnessShare / frequency};
    Stage stage;
    stage.name = "ring";
    stage.kind = StageKind::Dynamic;
    stage.duration = setting.steps * step;
    stage.timeStep = step;
    stage.integration = setting.scheme;
    stage.rhoInf = setting.rhoInf;
    scene.stages = {stage};
    scene.output.every = step;
    std::vector<double> series;
    for (const Frame& frame : runInMemory(scene).frames)
        if (series.empty() || frame.step > 0) series.push_back(frame.blocks[0].stress[0] / firstStress);
    return series;
}

std::vector<double> closedSeries(const ModeSetting& setting) {
    Eigen::Vector3d now(1.0, 0.0, -setting.eta * setting.eta);
    std::vector<double> series{1.0};
    for (int i = 0; i < setting.steps; ++i) {
        now = stepMatrix(setting) * now;
        series.push_back(now[0]);
    }
    return series;
}

int stepsRemembered(const ModeSetting& setting) {
    // with ρ∞ = 1 and initial accelerations in equilibrium, M·a = F after every step: a third value adds no information
    return setting.scheme == Integration::GeneralizedAlpha && setting.rhoInf < 1.0 ? 3 : 2;
}

double spectralRadius(const std::vector<double>& series, int order) {
    if (static_cast<int>(series.size()) < 2 * order) return std::nan("");
    Eigen::MatrixXd before(order, order), companion = Eigen::MatrixXd::Zero(order, order);
    Eigen::VectorXd next(order);
    for (int i = 0; i < order; ++i) {
        for (int j = 0; j < order; ++j) before(i, j) = series[i + j];
        next[i] = series[i + order];
    }
    companion.bottomRows<1>() = before.fullPivLu().solve(next).transpose();
    for (int i = 0; i + 1 < order; ++i) companion(i, i + 1) = 1.0;
    return radiusOf(companion);
}

double closedRadius(const ModeSetting& setting) { return radiusOf(stepMatrix(setting)); }

}  // namespace keyblock
