// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A friction bolt is pulled through a block, a gap and another block until it
// is out of both. Its resistance is its friction per metre times the length
// that is in rock, regardless of the positions of its nodes. The case is run
// statically and dynamically.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double boltFriction = 54e3;  // [N/m]
constexpr double firstEnd = 1.0, secondStart = 1.2, secondEnd = 2.2;  // [m] ends of the blocks along the bolt
constexpr double farEnd = 0.2, head = 3.0, drawn = 2.1;  // [m]
// [m/s], [s], [m]: in the dynamic run, the bolt is pulled at `drawSpeed` once it has moved by `faster`
constexpr double drawSpeed = 1.0, timeStep = 1e-3, faster = 0.1;
// [m] if less than this is embedded, deviations are relative to the friction over this length
constexpr double shortest = 0.02;

/// Two fixed blocks with a gap between them, and a third block that pulls the bolt by its head.
Scene drawnThrough() {
    Scene scene = emptyScene(rigidRock, 0.17, 0.0);
    scene.blocks = {boxBlock("first", {0, 0}, {firstEnd, 1}), boxBlock("second", {secondStart, 0}, {secondEnd, 1}),
                    boxBlock("puller", {2.6, 0}, {head, 1})};
    for (const double x : {0.5, 1.7}) {
        Support support;
        support.blockAt = Point(x, 0.1);
        scene.supports.push_back(support);
    }
    BoltType type = linearType(380e-6, 200e9);
    type.boltClass = BoltClass::CFC;
    Anchor rubbing = anchorRange(Per::Length, AnchorLaw::Frictional, 75e6, boltFriction, 0.0);
    rubbing.to = {false, 2.0};
    type.anchors = {rubbing, anchorAt(head - farEnd, AnchorLaw::Elastic, 1e9)};
    addBolt(scene, type, farEnd, head, 84, PlateKind::None);
    scene.monitors = {};
    Stage stage = pullStage(scene, drawn, 105);
    stage.motions.front().table = {{0.0, 0.0}, {1.0, drawn}};
    scene.stages = {stage};
    return scene;
}

/// Axial force where the bolt crosses x [N].
double axialForceAt(const BoltFrame& bolt, double x) {
    for (std::size_t n = 0; n + 1 < bolt.nodes.size(); ++n)
        if (bolt.nodes[n].position.x() <= x && bolt.nodes[n + 1].position.x() > x) return bolt.nodes[n].axialForce;
    return 0.0;
}

/// Results of the whole run: the largest values over all frames, and the force at the end.
struct Passage {
    double gapForce = 0.0, pullForce = 0.0;  // deviation, divided by friction × embedded length
    double balance = 0.0;  // energy balance error
    double balanceJump = 0.0;  // largest change of that error between frames
    int wayOfTip = 0;  // 1 if the tip was in block 1, in the gap, in block 2 and outside, in this order
    double lastForce = 0.0;  // [N]
};

/// \param from displacement of the tip from which every node slides [m]. \param lag distance that the tip moves in a
/// dynamic step, which uses the embedded lengths at its start [m].
void follow(Passage& passage, const Frame& frame, double from, double lag) {
    const BoltFrame& bolt = frame.bolts.front();
    const double tip = bolt.nodes.front().position.x() - lag;
    if (tip - farEnd < from) return;
    const double inFirst = std::max(0.0, firstEnd - tip);
    const double inBoth = inFirst + std::max(0.0, secondEnd - std::max(secondStart, tip));
    const auto off = [](double force, double embedded) {
        return std::abs(force - boltFriction * embedded) / (boltFriction * std::max(embedded, shortest));
    };
    passage.gapForce = std::max(passage.gapForce, off(axialForceAt(bolt, 0.5 * (firstEnd + secondStart)), inFirst));
    passage.lastForce = axialForceAt(bolt, 0.5 * (secondEnd + 2.6));
    passage.pullForce = std::max(passage.pullForce, off(passage.lastForce, inBoth));
}

Passage passageOf(const Results& results, double from, double lag) {
    Passage passage;
    std::vector<int> way;
    double before = 0.0;
    for (const Frame& frame : results.frames) {
        follow(passage, frame, from, lag);
        passage.balance = std::max(passage.balance, std::abs(frame.energy.balanceError));
        passage.balanceJump = std::max(passage.balanceJump, std::abs(frame.energy.balanceError - before));
        before = frame.energy.balanceError;
        const int block = frame.bolts.front().nodes.front().block;
        if (way.empty() || way.back() != block) way.push_back(block);
    }
    passage.wayOfTip = way == std::vector<int>{0, -1, 1, -1} ? 1 : 0;
    return passage;
}

void compare(Checks& checks, const std::string& how, const Scene& scene, double from, double lag) {
    const Solved solved = solve(scene);
    const Passage passage = passageOf(solved.results, from, lag);
    checks.absolute(how + ": force in the gap, deviation from friction × embedded length", passage.gapForce, 0.0, 1e-2);
    checks.absolute(how + ": force behind the second block, likewise", passage.pullForce, 0.0, 1e-2);
    checks.absolute(how + ": force at the end [N]", passage.lastForce, 0.0, 1e-2 * boltFriction * shortest);
    checks.absolute(how + ": the tip's blocks are 1, none, 2, none", passage.wayOfTip, 1.0, 0.0);
    checks.absolute(how + ": pulled out of a block", countOf(solved, EventKind::PulledOut), 2.0, 0.0);
    checks.absolute(how + ": debondings after the first loading", countOf(solved, EventKind::Debonding), 54.0, 0.0);
    checks.absolute(how + ": largest energy balance error", passage.balance, 0.0, 1e-2);
    checks.absolute(how + ": largest jump of that error", passage.balanceJump, 0.0, 1e-2);
}

std::vector<CaseResult> pullRightOut() {
    Checks checks("pull right out");
    Scene scene = drawnThrough();
    compare(checks, "static", scene, 0.02, 0.0);
    Stage& stage = scene.stages.front();
    stage.kind = StageKind::Dynamic;
    stage.increments.reset();
    const double start = 2.0 * faster / drawSpeed;
    stage.duration = start + (drawn - faster) / drawSpeed;
    stage.timeStep = timeStep;
    stage.motions.front().table = {{0.0, 0.0}, {start, faster}, {stage.duration, drawn}};
    compare(checks, "in motion", scene, faster, drawSpeed * timeStep);
    return checks.take();
}

}  // namespace

std::vector<Case> pullOutCases() {
    return {{"pull right out", "A friction bolt is pulled through a block, a gap and another "
                               "block until it is free.", pullRightOut}};
}

}  // namespace keyblock
