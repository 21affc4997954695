// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes with a bolt whose force follows from statics or from the closed form of a bar
// in an elastic or perfectly plastic bond.
#include "solver/verify/extremes/scene_parts.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using BoltAxes = std::vector<std::string>;

BoltAxes boltAxesOf(std::initializer_list<BoltAxes> lists) {
    BoltAxes all;
    for (const BoltAxes& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

const BoltAxes barAxes{"bond", "divisions", "bar-modulus", "modulus", "contrast"};
const BoltAxes settingAxes{"penalty", "tolerance", "max-passes", "contact",  "iteration",
                           "offset",  "turn",      "mirror",     "thickness"};

BoltType barOf(const Conditions& c, AnchorLaw law, std::optional<double> strength) {
    BoltType bar = linearType(barArea(), c.barModulus);
    bar.density = 1e-3;
    bar.anchors = {anchorRange(Per::Length, law, c.bond, strength, 0.0)};
    bar.normalStiffness.reset();
    return bar;
}

void addBar(Scene& scene, const Conditions& c, const BoltType& bar, const Point& farEnd, const Point& head) {
    scene.boltTypes = {bar};
    Bolt bolt;
    bolt.name = "B";
    bolt.type = bar.name;
    bolt.farEnd = farEnd;
    bolt.head = head;
    if (c.divisions >= 1.0) bolt.divisions = static_cast<int>(std::lround(c.divisions));
    bolt.plate = PlateKind::None;
    scene.bolts = {bolt};
}

double axialStiffness(const Conditions& c) { return c.barModulus * barArea(); }

/// Length over which the bond transfers a force [m].
double transferLength(const Conditions& c) { return std::sqrt(axialStiffness(c) / c.bond); }

/// Length of the bar in each block [m].
constexpr double embedded = 1.0;

/// Way by which one end of the bar of length 1 m is pulled out of its block by a force [m].
double pulledBy(const Conditions& c, double force) {
    const double transfer = transferLength(c);
    return force * transfer / axialStiffness(c) / std::tanh(embedded / transfer);
}

/// Largest way for which the length in the blocks is that at the start [m].
constexpr double mostWay = 0.005;

/// A bond of stiffness k on the length L − s that is left after the way s carries at most k·L²/4.
bool isTornOut(const Conditions& c, double force) { return force > 1.1 * 0.25 * c.bond * embedded * embedded; }

// --- a block hung on a bolt

Scene hung(const Conditions& c) {
    Scene scene = conditionedScene(c);
    scene.jointMaterials[0].second.frictionAngle = 0.0;
    scene.materials[0].second.density = c.load * 1e3 / 9.81 / c.thickness;
    addBase(scene, {-1.0, 0.0}, {2.0, 2.0});
    scene.blocks.push_back(boxBlock("box", {0.0, -1.0}, {1.0, 0.0}));
    addBar(scene, c, barOf(c, AnchorLaw::Elastic, std::nullopt), {0.5, 1.0 - 1e-7}, {0.5, -1.0 + 1e-7});
    scene.stages = {conditionedRest()};
    return scene;
}

double hungWeight(const Conditions& c) { return c.load * 1e3 * c.gravity / 9.81; }

/// The bar carries the weight, and the joint opens by what the bond and the bar give on both sides.
void judgeHung(const Conditions& c, const Solved& solved, Findings& findings) {
    const double weight = hungWeight(c);
    if (isTornOut(c, weight)) return findings.holds("the block falls off the bolt", endedUnstable(solved));
    const double way = 2.0 * pulledBy(c, weight) + 0.5 * weight / c.modulus / c.thickness;
    if (way > mostWay) return;
    findings.holds("the block hangs", endedWell(solved));
    findings.near("axial force, N", axialForce(solved), weight,
                  forceShare(c) * weight + 1e-14 * axialStiffness(c));
    findings.near(
        "sinking, m", -moved(c, solved, 1).y(), way,
        0.015 * way + weight / (c.modulus * c.thickness) + weight / (c.modulus * c.contrast * c.thickness) + 1e-15);
}

bool hungApplies(const Conditions& c) { return 2.0 * pulledBy(c, hungWeight(c)) < 0.01 && c.gravity > 0.0; }

// --- a bar pulled by a force

Scene twoJoined(const Conditions& c) {
    Scene scene = conditionedScene(c);
    scene.analysis.gravity = {0.0, 0.0};
    scene.jointMaterials[0].second.frictionAngle = 0.0;
    addBase(scene, {0, 0}, {1, 1});
    scene.blocks.push_back(boxBlock("box", {1, 0}, {2, 1}));
    return scene;
}

Scene pulledBar(const Conditions& c) {
    Scene scene = twoJoined(c);
    scene.materials[0].second.youngsModulus = scene.materials[1].second.youngsModulus = 6e13;
    addBar(scene, c, barOf(c, AnchorLaw::Elastic, std::nullopt), {1e-7, 0.5}, {2.0 - 1e-7, 0.5});
    Stage stage = conditionedRest();
    Load load;
    load.blockAt = Point(1.5, 0.1);
    load.force = {c.load * 1e3, 0.0};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    stage.loads = {load};
    scene.stages = {stage};
    return scene;
}

/// N = F, and the joint opens by 2·F·ℓ/EA·coth(L/ℓ), where ℓ is the transfer length.
void judgePulledBar(const Conditions& c, const Solved& solved, Findings& findings) {
    const double force = c.load * 1e3;
    if (isTornOut(c, force)) return findings.holds("the bolt is torn out", endedUnstable(solved));
    const double way = 2.0 * pulledBy(c, force);
    if (way > mostWay) return;
    findings.holds("the block comes to rest", endedWell(solved));
    findings.near("axial force, N", axialForce(solved), force,
                  forceShare(c) * force + 1e-14 * axialStiffness(c));
    findings.near("opening, m", moved(c, solved, 1).x(), way, 0.015 * way + force / 6e13 / c.thickness + 1e-15);
}

bool pulledApplies(const Conditions& c) { return 2.0 * pulledBy(c, c.load * 1e3) < 0.01; }

// --- a bar whose ends lie outside the rock

Scene freeEnds(const Conditions& c) {
    Scene scene = pulledBar(c);
    scene.bolts[0].farEnd.x() = -c.ratio;
    scene.bolts[0].head.x() = 2.0 + c.ratio;
    return scene;
}

/// Only where both ends are outside the rock, or in it by less than the transfer length shows.
void judgeFreeEnds(const Conditions& c, const Solved& solved, Findings& findings) {
    if (c.ratio > -2e-3) judgePulledBar(c, solved, findings);
}

// --- a bar along the joint between two fixed blocks, through the point where they meet the pulled one

Scene throughVertex(const Conditions& c) {
    Scene scene = pulledBar(c);
    const double joint = 0.5 - c.ratio;
    Block upper = scene.blocks[0];
    upper.name = "upper";
    scene.blocks[0].points = {{0, 0}, {1, 0}, {1, joint}, {0, joint}};
    upper.points = {{0, joint}, {1, joint}, {1, 1}, {0, 1}};
    scene.supports[0].blockAt = Point(0.5, 0.5 * joint);
    scene.blocks.push_back(upper);
    Support support;
    support.blockAt = Point(0.5, 0.5 * (1.0 + joint));
    scene.supports.push_back(support);
    return scene;
}

// --- a bar that is held by its face plate alone, near a corner

Scene plateAtCorner(const Conditions& c) {
    Scene scene = pulledBar(c);
    const double height = c.ratio;
    BoltType& bar = scene.boltTypes[0];
    bar.anchors[0].to = {false, 1.0};
    bar.plate.normalStiffness = 1e9;
    Bolt& bolt = scene.bolts[0];
    bolt.farEnd.y() = bolt.head.y() = height;
    bolt.plate = PlateKind::Spring;
    Load& load = scene.stages[0].loads[0];
    load.at = Point(1.5, height);
    return scene;
}

/// N = F: the load acts in the line of the bar, so the pulled block does not turn.
void judgePlateAtCorner(const Conditions& c, const Solved& solved, Findings& findings) {
    const double force = c.load * 1e3;
    if (pulledBy(c, force) + force / 1e9 > mostWay) return;
    findings.holds("the block comes to rest", endedWell(solved));
    findings.near("axial force, N", axialForce(solved), force, forceShare(c) * force + 1e-14 * axialStiffness(c));
}

// --- a bar with friction pulled out of its hole

constexpr double rubbing = 100e3;  // [N/m] friction of the bar

Scene pulledOut(const Conditions& c) {
    Scene scene = twoJoined(c);
    addBar(scene, c, barOf(c, AnchorLaw::Frictional, rubbing), {1e-7, 0.5}, {2.0 - 1e-7, 0.5});
    Stage stage = conditionedRest();
    Motion motion;
    motion.blockAt = {1.5, 0.1};
    motion.table = {{0.0, 0.0}, {1.0, c.ratio}};
    stage.motions = {motion};
    scene.stages = {stage};
    return scene;
}

/// Axial force where the bar leaves the first block [N]. The bar may keep a force of its own in its hole, where friction
/// locks it.
double forceAtJoint(const Solved& solved) {
    const std::vector<BoltNodeFrame>& nodes = solved.results.frames.back().bolts.front().nodes;
    double force = 0.0;
    for (std::size_t n = 0; n + 1 < nodes.size(); ++n)
        if (nodes[n].block == 0 && nodes[n + 1].block != 0) force = nodes[n].axialForce;
    return force;
}

/// The friction of the length that is still in the block, once all of it slides: p·(1 m − opening).
void judgePulledOut(const Conditions& c, const Solved& solved, Findings& findings) {
    const double full = rubbing * embedded, left = std::max(0.0, embedded - c.ratio) * rubbing;
    // all of it slides when the end farthest from the joint does
    const double slides = 2.0 * (rubbing / c.bond * std::cosh(std::min(40.0, embedded / transferLength(c))) +
                                 full * embedded / axialStiffness(c));
    const bool sliding = c.ratio > 2.0 * slides;
    // the bar stretches, and slips elastically on the side that does not slide
    const double stretched = (full * embedded / axialStiffness(c) + rubbing / c.bond) * rubbing;
    findings.holds("the block is pulled to the end", endedWell(solved) || endedUnstable(solved));
    const double force = forceAtJoint(solved);
    findings.atMost("axial force, N", force, left, 0.01 * full + stretched);
    if (sliding) findings.near("axial force of the sliding bar, N", force, left, 0.01 * full + stretched);
}

// --- many bolts fail at once

Scene manyBolts(const Conditions& c) {
    Scene scene = twoJoined(c);
    const int bolts = std::max(1, static_cast<int>(std::lround(c.ratio)));
    BoltType bar = barOf(c, AnchorLaw::PeakResidual, 1.0);
    bar.anchors[0].restick = false;
    addBar(scene, c, bar, {1e-7, 0.5}, {2.0 - 1e-7, 0.5});
    const Bolt first = scene.bolts.front();
    scene.bolts.clear();
    for (int i = 0; i < bolts; ++i) {
        Bolt bolt = first;
        bolt.name = "B" + std::to_string(i);
        bolt.farEnd.y() = bolt.head.y() = (i + 0.5) / bolts;
        bolt.divisions = 4;
        scene.bolts.push_back(bolt);
    }
    Stage stage = conditionedRest();
    Motion motion;
    motion.blockAt = {1.5, 0.1 / bolts};
    motion.table = {{0.0, 0.0}, {1.0, 0.05}};
    stage.motions = {motion};
    stage.increments = 1;
    scene.stages = {stage};
    return scene;
}

/// One side of every bond fails, and no bolt carries more than its residual strength, which is zero.
void judgeManyBolts(const Conditions& c, const Solved& solved, Findings& findings) {
    findings.holds("the block is pulled to the end", endedWell(solved));
    findings.near("way of the block, m", moved(c, solved, 1).x(), 0.05, 1e-6);
    double largest = 0.0;
    for (const BoltFrame& bolt : solved.results.frames.back().bolts)
        for (const BoltNodeFrame& node : bolt.nodes) largest = std::max(largest, std::abs(node.axialForce));
    findings.near("axial force, N", largest, 0.0, 1e-2);
    findings.holds("every bolt debonds", countOf(solved, EventKind::Debonding) >= std::lround(c.ratio));
}

// --- a bar along a joint

/// Two blocks on top of each other, the upper pulled along the joint by a force that the bar in the joint's direction
/// at the height `ratio` above it cannot see: both of its ends are in the upper block.
Scene alongJoint(const Conditions& c) {
    Scene scene = conditionedScene(c);
    addBase(scene, {-1.0, -1.0}, {3.0, 0.0});
    scene.blocks.push_back(boxBlock("box", {0.0, 0.0}, {2.0, 1.0}));
    addBar(scene, c, barOf(c, AnchorLaw::Elastic, std::nullopt), {0.25, c.ratio}, {1.75, c.ratio});
    scene.stages = {conditionedRest()};
    return scene;
}

/// The weight is on the slab, and the bar carries no more than the strain of the block gives it.
void judgeAlongJoint(const Conditions& c, const Solved& solved, Findings& findings) {
    const double weight = 2.0 * c.density * c.gravity * c.thickness;
    findings.holds("the box is stable", endedWell(solved));
    findings.near("force on the slab, N", contactsBetween(solved, 0, 1).normal, weight,
                  forceShare(c) * weight);
    const double strain = c.density * c.gravity / c.modulus;  // more than the block has anywhere
    findings.atMost("axial force, N", axialForce(solved), 0.0, axialStiffness(c) * strain + 1e-6 * weight);
}

Conditions boltWith(double Conditions::*member, double value) {
    Conditions conditions;
    conditions.*member = value;
    return conditions;
}

}  // namespace

std::vector<KnownScene> boltedScenes() {
    return {
        {"hung",
         "a block hung on a bolt",
         "axial force = weight; sinking of a bar in an elastic bond",
         {},
         boltAxesOf({{"force", "gravity"}, barAxes, settingAxes}),
         hung,
         judgeHung,
         hungApplies},
        {"pull",
         "a bolt pulled by a force",
         "axial force = load; opening = 2Fℓ/EA·coth(L/ℓ)",
         {},
         boltAxesOf({{"force", "bond", "divisions", "bar-modulus"}, settingAxes}),
         pulledBar,
         judgePulledBar,
         pulledApplies},
        {"free-ends", "a bolt whose ends lie outside the rock, pulled by a force", "as pull", boltWith(&Conditions::ratio, 0.1),
         {"distance", "divisions", "bond", "offset", "turn", "mirror"}, freeEnds, judgeFreeEnds, pulledApplies},
        {"vertex", "a bolt along a joint and through a point where three blocks meet", "as pull",
         boltWith(&Conditions::ratio, 0.1), {"distance", "bond", "offset", "turn", "mirror"}, throughVertex, judgePulledBar,
         pulledApplies},
        {"plate-corner", "a bolt held by its face plate, near a corner of the block", "axial force = load",
         boltWith(&Conditions::ratio, 0.3), {"distance", "force", "penalty", "offset", "turn", "mirror"}, plateAtCorner,
         judgePlateAtCorner},
        {"pull-out", "a friction bolt pulled out of its hole", "axial force = friction × length in the hole",
         boltWith(&Conditions::ratio, 0.2), boltAxesOf({{"opening"}, barAxes, settingAxes}), pulledOut, judgePulledOut},
        {"all-fail", "bolts whose bonds fail in one increment", "all debond, and none carries a force afterwards",
         boltWith(&Conditions::ratio, 2.0), boltAxesOf({{"bolts", "modulus", "contrast"}, settingAxes}), manyBolts,
         judgeManyBolts},
        {"along-joint", "a bolt along a joint",
         "force on the slab = weight; the bolt carries no more than the strain of its block",
         boltWith(&Conditions::ratio, 0.1), boltAxesOf({{"distance"}, barAxes, settingAxes}), alongJoint,
         judgeAlongJoint},
    };
}

}  // namespace keyblock
