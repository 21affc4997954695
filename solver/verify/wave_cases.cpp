// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wave in a bar of cells meets a joint, which transmits one part and reflects
// the other. Both ends of the bar absorb waves, so the steady state depends
// only on the joint.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

namespace keyblock {

namespace {

constexpr double waveModulus = 10e9, waveDensity = 2500.0;  // [Pa], [kg/m³]
constexpr double waveLength = 10.0;  // [m]
constexpr double cell = waveLength / 20.0;  // [m]
constexpr double waveStress = 1e3;  // [Pa] amplitude of the incident wave
constexpr double squeeze = 1e6;  // [Pa] in-situ compression that keeps the joint closed
constexpr int periods = 4;
// η = 0.0126: Shi's scheme reduces the amplitude by η/4 per radian, which is 1 % over half the bar
constexpr int stepsPerPeriod = 500;

double period() { return waveLength / std::sqrt(waveModulus / waveDensity); }

/// Displacement amplitude of the incident wave, σ/(Z·ω) [m].
double incident() {
    const double omega = 2.0 * std::numbers::pi / period();
    return waveStress / (std::sqrt(waveModulus * waveDensity) * omega);
}

/// Twice the incident wave as a pressure on the end, because the dashpot there absorbs half of it.
Load source() {
    constexpr int rows = 60;  // per period
    Load load;
    load.along = {Point(0.0, 0.0), Point(0.0, cell)};
    load.pressure = 2.0 * waveStress;
    for (int i = 0; i <= rows * periods; ++i)
        load.table.emplace_back(period() * i / rows, std::sin(2.0 * std::numbers::pi * i / rows));
    return load;
}

Stage waveStage() {
    Stage stage;
    stage.name = "wave";
    stage.kind = StageKind::Dynamic;
    stage.duration = periods * period();
    stage.timeStep = period() / stepsPerPeriod;
    stage.viscousBoundaries = {"left", "right"};
    stage.loads = {source()};
    return stage;
}

/// A bar one wavelength long with a joint of stiffness K·Z·ω in its middle. Supports at its ends balance the in-situ
/// stress.
Scene barScene(double k) {
    Scene scene = emptyScene(waveModulus, 0.0, 30.0);
    scene.materials[0].second.density = waveDensity;
    scene.jointMaterials[0].second.normalStiffness =
        k * std::sqrt(waveModulus * waveDensity) * 2.0 * std::numbers::pi / period();
    scene.blocks = {boxBlock("left", {0.0, 0.0}, {0.5 * waveLength, cell}),
                    boxBlock("right", {0.5 * waveLength, 0.0}, {waveLength, cell})};
    for (Block& block : scene.blocks) block.subBlocks = CellSettings{cell};
    InSituStress inSitu;
    inSitu.sxx = -squeeze;
    scene.inSituStress = inSitu;
    for (const double x : {0.0, waveLength})
        for (const double y : {0.0, cell}) {
            Support held;
            held.point = Point(x, y);
            held.fix = y == 0.0 ? Fix::XY : Fix::X;
            scene.supports.push_back(held);
        }
    for (const auto& [name, side] : {std::pair{"before", -1.0}, {"behind", 1.0}}) {
        Monitor monitor;
        monitor.name = name;
        monitor.point = Point(0.5 * waveLength + side * 0.01 * cell, 0.4 * cell);
        scene.monitors.push_back(monitor);
    }
    scene.stages = {waveStage()};
    scene.output.every = period() / 100.0;
    return scene;
}

/// Displacement amplitude at a monitor in the last period, divided by that of the incident wave.
double swing(const Solved& solved, const std::string& monitor) {
    const std::vector<double> u = series(solved, monitor);
    double low = INFINITY, high = -INFINITY;
    for (std::size_t i = 0; i < u.size(); ++i) {
        if (solved.results.history[i].time < (periods - 1) * period()) continue;
        low = std::min(low, u[i]);
        high = std::max(high, u[i]);
    }
    return 0.5 * (high - low) / incident();
}

/// The stress k·[u], with [u] the displacement jump, is the same on both sides of the joint. For an incident wave
/// e^(iωt), the wave behind the joint is T = 2K/(2K + i) with |T| = 2K/√(1 + 4K²) (Pyrak-Nolte, Myer and Cook 1990),
/// and the motion in front of it is 1 + (1 − T).
std::vector<CaseResult> jointInWave() {
    Checks checks("joint in a wave");
    for (const auto& [k, text, published] : {std::tuple{0.5, "0.5", 0.7071}, {1.0, "1", 0.8944}}) {
        const double passes = 2.0 * k / std::sqrt(1.0 + 4.0 * k * k);
        const double before = std::sqrt(4.0 - 3.0 * passes * passes);
        const std::string where = std::string(" at K ") + text + ", over the incident wave";
        const Solved solved = solve(barScene(k));
        checks.relative("transmitted" + where, swing(solved, "behind"), published, 0.05);
        checks.relative("motion before the joint" + where, swing(solved, "before"), before, 0.05);
    }
    return checks.take();
}

}  // namespace

std::vector<Case> waveCases() {
    return {{"joint in a wave", "A steady wave in a bar of cells crosses a joint and leaves at viscous ends.",
             jointInWave}};
}

}  // namespace keyblock
