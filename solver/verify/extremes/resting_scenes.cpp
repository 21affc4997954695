// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes at rest whose contact forces follow from statics.
#include "solver/verify/extremes/scene_parts.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

const std::vector<std::string> sectionAxes{"offset", "turn", "mirror", "size", "thickness", "plane"};
const std::vector<std::string> staticAxes{"penalty", "shear-ratio", "tolerance", "max-passes", "contact", "iteration"};
const std::vector<std::string> rockAxes{"modulus", "contrast", "density", "gravity", "friction", "cohesion", "poisson"};

std::vector<std::string> joined(std::initializer_list<std::vector<std::string>> lists) {
    std::vector<std::string> all;
    for (const std::vector<std::string>& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

// --- a box on a slab

Scene boxAtRest(const Conditions& c) {
    Scene scene = conditionedScene(c);
    addBase(scene, {-2.0 * c.size, -c.size}, {3.0 * c.size, 0.0});
    scene.blocks.push_back(boxBlock("box", {0, 0}, {c.size, c.size}));
    scene.stages = {conditionedRest()};
    return scene;
}

/// Least strain over that of a free bar, where friction keeps rock from expanding sideways in the section and, in plane
/// strain, out of it.
double heldShare(const Conditions& c) {
    const double nu = c.poisson;
    return c.plane == Plane::Stress ? 1.0 - nu * nu : (1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu);
}

/// The contacts carry the weight; the centre sinks by W/2k of the contacts and by ρgL²/4E of the box, or less where
/// friction keeps it from expanding.
void judgeBoxAtRest(const Conditions& c, const Solved& solved, Findings& findings) {
    const double weight = weightOf(c), contact = contactClosure(c, weight);
    const double free = weight / (4.0 * c.modulus * c.thickness), rock = 0.5 * (1.0 + heldShare(c)) * free;
    const Point u = moved(c, solved, 1);
    findings.holds("the box is stable", endedWell(solved));
    findings.near("force on the slab, N", contactsBetween(solved, 0, 1).normal, weight, forceShare(c) * weight);
    findings.near("settlement, m", -u.y(), contact + rock,
                  0.02 * contact + 0.5 * (1.0 - heldShare(c)) * free + 0.05 * free);
    findings.near("movement sideways, m", u.x(), 0.0, 0.05 * (contact + free));
    findings.near("rotation", lastBlock(solved, 1).rotation, 0.0, 0.05 * (contact + free) / c.size);
}

// --- a box on an incline

Scene boxOnIncline(const Conditions& c) {
    Scene scene = conditionedScene(c);
    const double a = c.slope * degree;
    scene.analysis.gravity = {c.gravity * std::sin(a), -c.gravity * std::cos(a)};
    addBase(scene, {-2.0 * c.size, -c.size}, {6.0 * c.size, 0.0});
    scene.blocks.push_back(boxBlock("box", {0, 0}, {c.size, 0.5 * c.size}));
    scene.stages = {conditionedRest()};
    return scene;
}

/// It is stable exactly if the slope is less than the friction angle (and than that of toppling, tan α = 2); contacts
/// then carry W cos α and W sin α.
void judgeBoxOnIncline(const Conditions& c, const Solved& solved, Findings& findings) {
    const bool stable = c.slope < c.friction && std::tan(c.slope * degree) < 2.0;
    findings.holds(stable ? "the box is stable" : "the box is not stable",
                   stable ? endedWell(solved) : endedUnstable(solved));
    if (!stable) return;
    const double weight = weightOf(c, 1.0, 0.5), a = c.slope * degree;
    const Point force = contactForceOn(c, solved, 1);
    findings.near("normal force, N", force.y(), weight * std::cos(a), forceShare(c) * weight);
    findings.near("shear force, N", -force.x(), weight * std::sin(a), forceShare(c) * weight);
}

bool inclineApplies(const Conditions& c) {
    return std::abs(c.slope - c.friction) > 0.5 && std::abs(std::tan(c.slope * degree) - 2.0) > 0.1 &&
           c.cohesion == 0.0 && c.gravity > 0.0;
}

// --- a tower

int storeys(const Conditions& c) { return std::max(1, static_cast<int>(std::lround(c.ratio))); }

Scene tower(const Conditions& c) {
    Scene scene = conditionedScene(c);
    addBase(scene, {-2.0 * c.size, -c.size}, {3.0 * c.size, 0.0});
    for (int i = 0; i < storeys(c); ++i)
        scene.blocks.push_back(boxBlock("", {0, i * c.size}, {c.size, (i + 1) * c.size}));
    scene.stages = {conditionedRest()};
    return scene;
}

/// Every joint carries what is above it.
void judgeTower(const Conditions& c, const Solved& solved, Findings& findings) {
    findings.holds("the tower is stable", endedWell(solved));
    const int n = storeys(c);
    for (const int level : {0, n / 2, n - 1}) {
        const double above = weightOf(c) * (n - level);
        findings.near("force on level " + std::to_string(level) + ", N",
                      contactsBetween(solved, level, level + 1).normal, above, forceShare(c) * weightOf(c) * n);
    }
}

// --- a block on two pebbles

Scene onPebbles(const Conditions& c) {
    Scene scene = conditionedScene(c);
    const double pebble = c.size / c.ratio;
    addBase(scene, {-c.size, -c.size}, {2.0 * c.size, 0.0});
    scene.blocks.push_back(boxBlock("left", {0.1 * c.size, 0}, {0.1 * c.size + pebble, pebble}));
    scene.blocks.push_back(boxBlock("right", {0.9 * c.size - pebble, 0}, {0.9 * c.size, pebble}));
    scene.blocks.push_back(boxBlock("block", {0, pebble}, {c.size, pebble + c.size}));
    scene.stages = {conditionedRest()};
    return scene;
}

void judgeOnPebbles(const Conditions& c, const Solved& solved, Findings& findings) {
    findings.holds("the block is stable", endedWell(solved));
    for (const int pebble : {1, 2})
        findings.near("force on a pebble, N", contactsBetween(solved, pebble, 3).normal, 0.5 * weightOf(c),
                      forceShare(c) * weightOf(c));
}

// --- a sliver on a slab

double sliverHeight(const Conditions& c) { return c.size * std::tan(c.ratio * degree); }

Scene sliver(const Conditions& c) {
    Scene scene = conditionedScene(c);
    addBase(scene, {-c.size, -c.size}, {2.0 * c.size, 0.0});
    Block block = boxBlock("sliver", {0, 0}, {1, 1});
    block.points = {{0, 0}, {c.size, 0}, {0, sliverHeight(c)}};
    scene.blocks.push_back(block);
    Stage stage = conditionedRest();
    scene.stages = {stage};
    return scene;
}

void judgeSliver(const Conditions& c, const Solved& solved, Findings& findings) {
    const double weight = 0.5 * weightOf(c, 1.0, std::tan(c.ratio * degree));
    findings.holds("the sliver is stable", endedWell(solved));
    findings.near("force on the slab, N", contactsBetween(solved, 0, 1).normal, weight, forceShare(c) * weight);
}

// --- a box in a corner of a concave block, or above a gap

Scene inCorner(const Conditions& c) {
    Scene scene = conditionedScene(c);
    const double gap = c.ratio * c.size;
    addBase(scene, {-c.size, -c.size}, {3.0 * c.size, 0.0});
    scene.blocks[0].points = {{-c.size, -c.size}, {3.0 * c.size, -c.size}, {3.0 * c.size, 0},
                              {-gap, 0},          {-gap, 2.0 * c.size},    {-c.size, 2.0 * c.size}};
    scene.blocks.push_back(boxBlock("box", {0, 0}, {c.size, c.size}));
    scene.supports.front().blockAt = Point(0.5 * c.size, -0.5 * c.size);
    scene.stages = {conditionedRest()};
    return scene;
}

/// The floor carries the box; the wall, which may touch it, carries at most the push of its lateral expansion.
void judgeInCorner(const Conditions& c, const Solved& solved, Findings& findings) {
    const double weight = weightOf(c);
    findings.holds("the box is stable", endedWell(solved));
    findings.near("vertical force on the box, N", contactForceOn(c, solved, 1).y(), weight, forceShare(c) * weight);
    findings.near("rotation", lastBlock(solved, 1).rotation, 0.0, 2.0 * restingDeflection(c) / c.size);
}

Scene aboveGap(const Conditions& c) {
    Scene scene = boxAtRest(c);
    for (Point& p : scene.blocks[1].points) p.y() += c.ratio * c.size;
    return scene;
}

void judgeAboveGap(const Conditions& c, const Solved& solved, Findings& findings) {
    const double weight = weightOf(c), gap = c.ratio * c.size;
    findings.holds("the box comes to rest", endedWell(solved) || endedUnstable(solved));
    findings.near("force on the slab, N", contactsBetween(solved, 0, 1).normal, weight, forceShare(c) * weight);
    findings.near("way of the box, m", -moved(c, solved, 1).y(), gap + restingDeflection(c),
                  1e-3 * gap + 0.5 * restingDeflection(c));
}

// --- a key block between frictionless abutments

/// Half the width of the key block at height y, which its sides reach at the angle `slope` from the vertical.
Scene keystone(const Conditions& c) {
    Scene scene = conditionedScene(c);
    const double tangent = std::tan(c.slope * degree), low = 0.5 * c.size, high = low + tangent * c.size;
    Block left = boxBlock("left", {0, 0}, {1, 1}), right = left, key = left;
    left.material = right.material = "base";
    left.points = {{-high - c.size, 0}, {-low, 0}, {-high, c.size}, {-high - c.size, c.size}};
    right.name = "right";
    right.points = {{low, 0}, {high + c.size, 0}, {high + c.size, c.size}, {high, c.size}};
    key.name = "key";
    key.points = {{-low, 0}, {low, 0}, {high, c.size}, {-high, c.size}};
    scene.blocks = {left, right, key};
    for (const double side : {-1.0, 1.0}) {
        Support support;
        support.blockAt = Point(side * (high + 0.8 * c.size), 0.5 * c.size);
        scene.supports.push_back(support);
    }
    scene.stages = {conditionedRest()};
    return scene;
}

/// W/2 = N·sin β on each side, without friction. Contacts and block give way by N/2k and N/2E, so the block sinks by
/// these over tan β: a thin wedge is pressed through.
void judgeKeystone(const Conditions& c, const Solved& solved, Findings& findings) {
    const double sine = std::sin(c.slope * degree), tangent = std::tan(c.slope * degree);
    const double weight = weightOf(c, 1.0 + tangent, 1.0), expected = 0.5 * weight / sine;
    const double gives = contactClosure(c, expected) + 0.5 * expected / c.modulus / c.thickness;
    const double sinks = (gives + 0.5 * weight / c.modulus / c.thickness) / tangent / c.size;
    if (sinks > 0.25) findings.holds("the key block is not stable", endedUnstable(solved));
    if (sinks > 0.05) return;
    findings.holds("the key block is stable", endedWell(solved));
    for (const int side : {0, 1})
        findings.near("force of an abutment, N", contactsBetween(solved, side, 2).normal, expected,
                      (std::max(2e-3, forceShare(c)) + 3.0 * gives / c.size) * expected);
}

// --- a block under pressure

Scene pressed(const Conditions& c) {
    Scene scene = boxAtRest(c);
    Load load;
    load.along = {Point(0, c.size), Point(c.size, c.size)};
    load.pressure = c.load * 1e6;
    scene.stages[0].loads = {load};
    return scene;
}

/// σyy = −p, and the slab carries p·L, where the pressure follows the edge as it widens; contacts are frictionless.
void judgePressed(const Conditions& c, const Solved& solved, Findings& findings) {
    const double pressure = c.load * 1e6, strain = pressure / c.modulus;
    findings.holds("the block is stable", endedWell(solved));
    const double own = std::max(1e-2, forceShare(c));
    const double whole = pressure * c.size * c.thickness, widens = 1.0 + c.poisson * strain;
    findings.near("force on the slab, N", contactsBetween(solved, 0, 1).normal, whole * widens,
                  (own + 0.1 * strain + strain * strain) * whole);
    if (c.turn == 0.0)
        findings.near("vertical stress, Pa", lastBlock(solved, 1).stress[1], -pressure, (0.02 + strain) * pressure);
    const double expected = pressure * c.size / 2.0 / c.modulus + contactClosure(c, whole);
    if (c.plane == Plane::Stress)
        findings.near("settlement, m", -moved(c, solved, 1).y(), expected, (0.01 + 2.0 * strain) * expected);
}

// --- free of everything

Scene alone(const Conditions& c) {
    Scene scene = conditionedScene(c);
    scene.blocks = {boxBlock("box", {0, 0}, {c.size, c.size})};
    scene.stages = {conditionedRest()};
    return scene;
}

/// A block that touches nothing falls; without gravity it stays where it is.
void judgeAlone(const Conditions& c, const Solved& solved, Findings& findings) {
    if (c.gravity > 0.0) findings.holds("the block falls", endedUnstable(solved));
    else {
        findings.holds("the block is at rest", endedWell(solved));
        findings.near("movement, m", moved(c, solved, 0).norm(), 0.0, 1e-12 * c.size);
    }
}

Conditions with(double Conditions::*member, double value, Conditions conditions = {}) {
    conditions.*member = value;
    return conditions;
}

}  // namespace

std::vector<KnownScene> restingScenes() {
    const Conditions smooth = with(&Conditions::friction, 0.0);
    return {
        {"box",
         "a box settles on a fixed slab",
         "force on the slab = weight; settlement by Hooke's law",
         {},
         joined({sectionAxes, staticAxes, rockAxes}),
         boxAtRest,
         judgeBoxAtRest},
        {"incline", "a box on an incline", "stable exactly below the friction angle; N = W cos α, T = W sin α",
         with(&Conditions::slope, 20.0), joined({{"slope"}, sectionAxes, staticAxes, rockAxes}), boxOnIncline,
         judgeBoxOnIncline, inclineApplies},
        {"tower", "blocks on top of each other", "every joint carries the weight above it",
         with(&Conditions::ratio, 10.0), joined({{"number"}, sectionAxes, staticAxes, rockAxes}), tower, judgeTower},
        {"pebbles", "a block on two small blocks", "each carries half of the weight", with(&Conditions::ratio, 5.0),
         joined({{"size-ratio"}, sectionAxes, staticAxes, {"contrast", "modulus", "friction"}}), onPebbles,
         judgeOnPebbles},
        {"sliver", "a thin triangle on a slab", "force on the slab = weight", with(&Conditions::ratio, 20.0),
         joined({{"sliver-angle"}, sectionAxes, staticAxes, {"contrast", "friction", "modulus"}}), sliver, judgeSliver},
        {"corner", "a box next to the wall of a concave block", "the vertical force on it is its weight",
         with(&Conditions::ratio, 0.01),
         joined({{"gap"}, sectionAxes, {"penalty", "tolerance", "contrast", "friction"}}), inCorner, judgeInCorner},
        {"gap", "a box a little above a slab", "it comes down by the gap; force on the slab = weight",
         with(&Conditions::ratio, 1e-3),
         joined({{"gap"}, sectionAxes, {"penalty", "tolerance", "contrast", "friction"}}), aboveGap, judgeAboveGap},
        {"keystone", "a key block between frictionless abutments", "force of an abutment = W/(2 sin β)",
         with(&Conditions::slope, 20.0, smooth),
         joined({{"flank-angle"}, sectionAxes, staticAxes, {"modulus", "contrast", "density", "gravity"}}), keystone,
         judgeKeystone},
        {"press", "pressure on a block on a slab", "force on the slab = p·L, stress = −p, settlement by Hooke's law",
         with(&Conditions::gravity, 0.0, smooth),
         joined({{"pressure"}, sectionAxes, staticAxes, {"modulus", "contrast", "poisson"}}), pressed, judgePressed},
        {"alone",
         "a block that touches nothing",
         "it falls; without gravity it stays where it is",
         {},
         joined({{"gravity"}, sectionAxes, {"density", "modulus", "penalty", "tolerance"}}),
         alone,
         judgeAlone},
    };
}

}  // namespace keyblock
