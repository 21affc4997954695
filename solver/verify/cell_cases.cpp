// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks divided into cells: a uniform stress must be reproduced, a beam must
// deflect according to beam theory, and a bar must vibrate at its natural
// frequency. The compliance that the bonds between cells add is within every
// tolerance here.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace keyblock {

namespace {

constexpr double modulus = 10e9;  // [Pa]

Block cutBlock(const std::string& name, const Point& low, const Point& high, double size) {
    Block block = boxBlock(name, low, high);
    block.subBlocks = CellSettings{size};
    return block;
}

Monitor between(const std::string& name, const Point& a, const Point& b, const Point& axis) {
    Monitor monitor;
    monitor.name = name;
    monitor.between = {a, b};
    monitor.axis = axis;
    return monitor;
}

Load forceAt(const Point& place, const Point& force) {
    Load load;
    load.point = place;
    load.force = force;
    return load;
}

Support heldAt(const Point& place, Fix fix) {
    Support held;
    held.point = place;
    held.fix = fix;
    return held;
}

Stage staticStage(std::vector<Load> loads) {
    Stage stage;
    stage.name = "load";
    stage.loads = std::move(loads);
    stage.until.unbalanced = 1e-10;
    return stage;
}

/// Largest deviation of the stress in any cell from `expected` [Pa]; NaN if there are no results.
double stressDeviation(const Results& results, const std::array<double, 3>& expected) {
    if (results.frames.empty()) return std::nan("");
    double worst = 0.0;
    for (const BlockState& block : results.frames.back().blocks)
        for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, std::abs(block.stress[k] - expected[k]));
    return worst;
}

/// A plate of 2 m × 1 m in cells of 0.25 m, with statically determinate supports and a tension of 1 kPa at both ends.
/// Every cell carries 1 kPa, and the plate elongates by σ·L/E.
void pulledPlate(Checks& checks) {
    const double stress = 1e3;  // small enough for the squares of strains to be negligible
    Scene scene = emptyScene(modulus, 0.25, 30.0);
    scene.blocks = {cutBlock("plate", {0, 0}, {2, 1}, 0.25)};
    std::vector<Load> loads(2);
    for (const std::size_t end : {0u, 1u}) {
        loads[end].along = {Point(2.0 * static_cast<double>(end), 0.0), Point(2.0 * static_cast<double>(end), 1.0)};
        loads[end].pressure = -stress;
    }
    scene.supports = {heldAt({0, 0.375}, Fix::XY), heldAt({2, 0.375}, Fix::Y)};
    scene.stages = {staticStage(loads)};
    scene.monitors = {between("growth", {0, 0.6}, {2, 0.6}, {1, 0}), between("squeeze", {0.9, 0}, {0.9, 1}, {0, 1})};
    const Solved solved = solve(scene);
    checks.absolute("pull: largest deviation of a cell's stress [Pa]", stressDeviation(solved.results, {stress, 0, 0}),
                    0.0, 1e-6 * stress);
    checks.relative("pull: growth [m]", reading(solved, "last growth"), 2.0 * stress / modulus, 2e-3);
    checks.relative("pull: squeeze [m]", reading(solved, "last squeeze"), -0.25 * stress / modulus, 2e-3);
}

/// A square in cells of 0.25 m with tangential tractions τ on all sides: the shear strain of every cell is τ/G.
void shearedPlate(Checks& checks) {
    const double stress = 1e3, edge = 0.25;
    Scene scene = emptyScene(modulus, 0.25, 30.0);
    scene.blocks = {cutBlock("plate", {0, 0}, {1, 1}, edge)};
    std::vector<Load> loads;
    for (int i = 0; i < 4; ++i) {
        const double s = edge * (i + 0.5), force = stress * edge;
        loads.push_back(forceAt({0, s}, {0, -force}));
        loads.push_back(forceAt({1, s}, {0, force}));
        loads.push_back(forceAt({s, 0}, {-force, 0}));
        loads.push_back(forceAt({s, 1}, {force, 0}));
    }
    scene.supports = {heldAt({0, 0.375}, Fix::XY), heldAt({1, 0.375}, Fix::Y)};
    scene.stages = {staticStage(loads)};
    const double diagonal = 1.0 / std::numbers::sqrt2;
    scene.monitors = {between("long diagonal", {0, 0}, {1, 1}, {diagonal, diagonal})};
    const Solved solved = solve(scene);
    const double shear = stress / (0.5 * modulus / 1.25);
    checks.absolute("shear: largest deviation of a cell's stress [Pa]", stressDeviation(solved.results, {0, 0, stress}),
                    0.0, 1e-6 * stress);
    checks.relative("shear: growth of a diagonal [m]", reading(solved, "last long diagonal"), diagonal * shear, 2e-3);
}

std::vector<CaseResult> patch() {
    Checks checks("patch of cells");
    pulledPlate(checks);
    shearedPlate(checks);
    return checks.take();
}

/// Tip deflection of a beam of 10 m × 1 m in `rows` rows of cells under a force at its end, divided by the deflection
/// of a beam with shear deformation, P·L³/3EI + P·L/κGA with κ = 10(1+ν)/(12+11ν) (Cowper 1966).
double cantilever(int rows) {
    const double length = 10.0, depth = 1.0, force = 1e3, nu = 0.25;
    Scene scene = emptyScene(modulus, nu, 30.0);
    scene.analysis.penaltyRatio = 1e4;  // makes the point supports stiff compared with the beam
    scene.blocks = {cutBlock("beam", {0, 0}, {length, depth}, depth / rows)};
    std::vector<Load> loads;
    for (int i = 0; i < rows; ++i) {
        const double y = depth * (i + 0.5) / rows;
        scene.supports.push_back(heldAt({0.0, y}, Fix::XY));
        loads.push_back(forceAt({length, y}, {0.0, -force / rows}));
    }
    scene.stages = {staticStage(loads)};
    Monitor tip;
    tip.name = "tip";
    tip.point = Point(length, depth * (0.5 + 0.1 / rows));
    scene.monitors = {tip};
    const double bending = force * std::pow(length, 3) / (3.0 * modulus * std::pow(depth, 3) / 12.0);
    const double kappa = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    const double shear = force * length / (kappa * 0.5 * modulus / (1.0 + nu) * depth);
    return -reading(solve(scene), "last tip.uy") / (bending + shear);
}

std::vector<CaseResult> cantilevers() {
    Checks checks("cantilever of sub-blocks");
    checks.relative("tip deflection over the beam's, 2 × 20 cells", cantilever(2), 1.0, 0.05);
    checks.relative("tip deflection over the beam's, 4 × 40 cells", cantilever(4), 1.0, 0.02);
    checks.relative("tip deflection over the beam's, 8 × 80 cells", cantilever(8), 1.0, 0.01);
    return checks.take();
}

/// Mean period [s] of the upward crossings of `level` by `values`.
double periodOf(const Solved& solved, const std::vector<double>& values, double level) {
    std::vector<double> passed;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const HistoryRow &before = solved.results.history[i - 1], &now = solved.results.history[i];
        if (values[i - 1] >= level || values[i] < level) continue;
        const double share = (level - values[i - 1]) / (values[i] - values[i - 1]);
        passed.push_back(before.time + share * (now.time - before.time));
    }
    return passed.size() < 2 ? std::nan("") : (passed.back() - passed.front()) / static_cast<double>(passed.size() - 1);
}

/// A free bar of 10 m in cells of 0.25 m that starts with an unbalanced stress. Its length oscillates about the
/// stress-free length with the period 2L/c, c = √(E/ρ).
std::vector<CaseResult> ringingBar() {
    Checks checks("bar of cells");
    const double length = 10.0, stress = 1e6;
    Scene scene = emptyScene(modulus, 0.0, 30.0);
    scene.blocks = {cutBlock("bar", {0, 0}, {length, 0.25}, 0.25)};
    scene.blocks[0].initialStress = {stress, 0.0, 0.0};
    const double period = 2.0 * length * std::sqrt(2700.0 / modulus);
    Stage stage;
    stage.name = "ring";
    stage.kind = StageKind::Dynamic;
    stage.duration = 6.2 * period;
    stage.timeStep = period / 400.0;
    scene.stages = {stage};
    scene.output.every = period / 400.0;
    scene.monitors = {between("length", {0, 0.1}, {length, 0.1}, {1, 0})};
    const Solved solved = solve(scene);
    checks.relative("period of the free bar [s]",
                    periodOf(solved, series(solved, "length"), -stress * length / modulus), period, 5e-3);
    return checks.take();
}

/// Moment at which the first contact of a bonded joint fails [N m], and the height of that contact [m].
struct Crack {
    double moment = 0.0, height = 0.0;
};

/// A beam of 6 m × 1 m with a bonded joint at mid-span, bent by two pairs of forces. \param rows rows of cells; 0: the
/// two halves are whole blocks.
Crack crackOf(int rows, double tensileStrength, std::optional<double> normalStiffness) {
    const double length = 6.0, depth = 1.0, cell = depth / std::max(rows, 1);
    Scene scene = emptyScene(modulus, 0.2, 40.0);
    scene.analysis.plane = Plane::Stress;
    JointMaterial& joint = scene.jointMaterials.front().second;
    joint.cohesion = 100.0 * tensileStrength;
    joint.tensileStrength = tensileStrength;
    joint.normalStiffness = joint.shearStiffness = normalStiffness;
    scene.blocks = {cutBlock("left", {0, 0}, {0.5 * length, depth}, cell),
                    cutBlock("right", {0.5 * length, 0}, {length, depth}, cell)};
    if (rows == 0)
        for (Block& half : scene.blocks) half.subBlocks.reset();
    const auto middleOfCell = [&](double x) { return (std::floor(x / cell) + 0.5) * cell; };
    const double outer = middleOfCell(0.5), inner = middleOfCell(2.0);
    const double most = (rows == 0 ? 4.0 : 1.3) * tensileStrength * depth * depth / 6.0;
    const double force = most / (inner - outer) * cell / depth;
    Stage stage = staticStage({});
    stage.until.unbalanced = 1e-6;
    for (double y = 0.5 * cell; y < depth; y += cell)
        for (const double x : {outer, inner, length - inner, length - outer}) {
            const bool isOuter = x == outer || x == length - outer;
            stage.loads.push_back(forceAt({x, y}, {0.0, isOuter ? force : -force}));
            stage.loads.back().table = Table{{0.0, 0.0}, {1.0, 1.0}};
        }
    scene.supports = {heldAt({0.5 * length - 0.3, 0.5 * cell}, Fix::XY), heldAt({0.5 * length + 0.3, 0.5 * cell}, Fix::Y)};
    scene.stages = {stage};
    scene.limits.iterations = 40;  // enough to reach the first crack
    const Solved solved = solve(scene);
    if (solved.results.events.empty()) return {std::nan(""), std::nan("")};
    const Event& first = solved.results.events.front();
    return {most * first.time, first.position.y()};
}

std::vector<CaseResult> cracks() {
    Checks checks("crack of a bent beam");
    const double strength = 1e5, beam = strength / 6.0;
    const std::array<std::pair<int, double>, 3> rows{{{2, 0.10}, {4, 0.05}, {8, 0.03}}};
    for (const auto& [count, tolerance] : rows)
        for (const std::optional<double> stiffness : {std::optional<double>(), std::optional<double>(1e11)}) {
            const Crack crack = crackOf(count, strength, stiffness);
            const std::string of = std::to_string(count) + " rows of cells" + (stiffness ? ", joint of 1e11 Pa/m" : "");
            checks.relative("moment at the first crack over the beam's, " + of, crack.moment / beam, 1.0, tolerance);
            checks.absolute("height of the first crack, " + of + " [m]", crack.height, 0.0, 1e-3);
        }
    checks.relative("moment at the first crack over the beam's, whole blocks", crackOf(0, strength, {}).moment / beam, 3.0,
                    1e-3);
    return checks.take();
}

}  // namespace

std::vector<Case> cellCases() {
    return {
        {"patch of cells", "A block in cells under uniform tension and shear.", patch},
        {"cantilever of sub-blocks", "A beam of span 10 × depth in cells bends as a beam with shear.", cantilevers},
        {"crack of a bent beam", "A bonded joint between blocks in cells cracks at the tension edge under f_t·h²/6.", cracks},
        {"bar of cells", "A free bar of cells vibrates at the frequency given by its length.", ringingBar},
    };
}

}  // namespace keyblock
