// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The opening sample, a drift with grouted rebars on the left and D-bolts on the
// right, against laws that are evaluated here from the numbers of its scene file:
// shear lag of an elastic bond, friction over the length still embedded, strength
// of the steel. Nothing of the engine is used for them.
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "solver/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace keyblock {
namespace {

constexpr double rebarArea = std::numbers::pi * 0.01 * 0.01;  // [m²]
constexpr double youngsModulus = 490e6 / 0.0023;  // [Pa] first piece of the steel's curve
constexpr double bondStiffness = 2543.4e6, bondPeak = 736.8e3, bondResidual = 67.2e3;  // per metre
constexpr double firstYield = 490e6 * rebarArea, ultimate = 630e6 * rebarArea;  // [N]

struct Rebar {
    std::string name;
    int bolt = -1;
    double embedded = 0.0;  // [m] beyond the joint over the wedge, at the start
};

int boltNamed(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.bolts.begin(), scene.bolts.end(), [&](const Bolt& b) { return b.name == name; });
    return found == scene.bolts.end() ? -1 : static_cast<int>(found - scene.bolts.begin());
}

/// The wedge is the part of the roof under the first joint of the scene, two straight faces that meet at its second point.
Rebar rebarNamed(const Scene& scene, const std::string& name) {
    Rebar rebar{name, boltNamed(scene, name), 0.0};
    const auto& face = scene.joints.front().points;
    const Point far = scene.bolts[rebar.bolt].farEnd;
    const Point& foot = far.x() < face[1].x() ? face[0] : face[2];
    const double share = (far.x() - foot.x()) / (face[1].x() - foot.x());
    rebar.embedded = far.y() - (foot.y() + share * (face[1].y() - foot.y()));
    return rebar;
}

/// Force at the joint [N] at which a bar embedded over `length` reaches the peak of its bond: N(x) of shear lag, with
/// the end of the bar free and the slip at the joint bondPeak/bondStiffness.
double shearLagLoad(double length) {
    const double decay = std::sqrt(bondStiffness / (youngsModulus * rebarArea));  // [1/m]
    return bondPeak / decay * std::tanh(decay * length);
}

const Event* firstOf(const Results& results, EventKind kind, int bolt) {
    const auto found = std::find_if(results.events.begin(), results.events.end(),
                                    [&](const Event& e) { return e.kind == kind && e.bolt == bolt; });
    return found == results.events.end() ? nullptr : &*found;
}

long countOf(const Results& results, EventKind kind) {
    return std::count_if(results.events.begin(), results.events.end(), [&](const Event& e) { return e.kind == kind; });
}

/// While the bar is drawn out of the rock beyond the joint: force at the joint against residual bond times the length
/// that is still embedded there, at every frame from a slip of `from` to `to` [m]. Earlier the bar still swings from the
/// release of its last node. \return the number of frames compared.
int compareSliding(const Results& results, const Rebar& rebar, double from, double to) {
    int compared = 0;
    for (const Frame& frame : results.frames) {
        const auto& nodes = frame.bolts[rebar.bolt].nodes;
        if (nodes.empty()) continue;
        const double slip = -nodes.front().slip;  // of the far end, out of its rock
        if (nodes.front().state != NodeState::Slipping || slip < from || slip > to) continue;
        const int wedge = nodes.back().block;
        const auto joint = std::find_if(nodes.begin(), nodes.end(), [&](const BoltNodeFrame& node) { return node.block == wedge; });
        const double force = std::prev(joint)->axialForce;
        const double expected = bondResidual * (rebar.embedded - slip);
        EXPECT_NEAR(force, expected, 0.02 * expected) << rebar.name << " at " << frame.time << " s, slip " << slip;
        ++compared;
    }
    return compared;
}

TEST(OpeningSample, RebarsDebondAndSlideOutAndDBoltsYieldAndHold) {
    const SceneReading reading = readSceneFile(KEYBLOCK_SAMPLES_DIR "/drift-rebar-dbolt.json");
    ASSERT_TRUE(reading.scene);
    const Scene& scene = *reading.scene;
    const Results results = runInMemory(scene);

    for (const StageResult& stage : results.stages) EXPECT_LT(std::abs(stage.health.balanceError), 1e-2) << stage.stage;

    const long debonded = countOf(results, EventKind::Debonding);
    EXPECT_GE(debonded, 20);
    EXPECT_LE(debonded, 60);
    EXPECT_EQ(countOf(results, EventKind::BlockFalls), 2);  // the wedge with its bars, and the block on it
    EXPECT_EQ(countOf(results, EventKind::TensileRupture) + countOf(results, EventKind::ShearRupture), 0);

    for (const char* name : {"R1", "R2"}) {
        SCOPED_TRACE(name);
        const Rebar rebar = rebarNamed(scene, name);
        const Event* first = firstOf(results, EventKind::Debonding, rebar.bolt);
        ASSERT_TRUE(first);
        // the node that fails is the next to the joint, so that the larger force beside it is the one at the joint
        EXPECT_NEAR(first->axialForce, shearLagLoad(rebar.embedded), 0.02 * shearLagLoad(rebar.embedded));
        EXPECT_TRUE(firstOf(results, EventKind::PulledOut, rebar.bolt));
        EXPECT_GE(compareSliding(results, rebar, 2e-3, 2e-2), 1);
    }
    for (const char* name : {"D1", "D2"}) {
        SCOPED_TRACE(name);
        const int bolt = boltNamed(scene, name);
        EXPECT_TRUE(firstOf(results, EventKind::Yield, bolt));
        EXPECT_FALSE(firstOf(results, EventKind::Debonding, bolt));
        const double largest = results.frames.back().extremes[bolt].axialForce.value;
        EXPECT_GE(largest, firstYield);
        EXPECT_LT(largest, ultimate);
    }
}

using Failure = std::tuple<EventKind, int, int>;  // bolt and node

/// Debondings, and the first yield of each bolt: elements of one free length of a D-bolt carry the same force, so that
/// round-off decides which of them yields first.
std::vector<Failure> failuresOf(const Results& results) {
    std::vector<Failure> failures;
    std::set<int> yielded;
    for (const Event& event : results.events)
        if (event.kind == EventKind::Debonding)
            failures.emplace_back(event.kind, event.bolt, event.node);
        else if (event.kind == EventKind::Yield && yielded.insert(event.bolt).second)
            failures.emplace_back(event.kind, event.bolt, -1);
    return failures;
}

TEST(OpeningSample, BoltsFailInTheSameOrderAtHalfTheStep) {
    const SceneReading reading = readSceneFile(KEYBLOCK_SAMPLES_DIR "/drift-rebar-dbolt.json");
    ASSERT_TRUE(reading.scene);
    Scene coarse = *reading.scene;
    coarse.stages.pop_back();  // what falls there has failed before
    coarse.stages.back().duration = 0.16;
    Scene fine = coarse;
    ASSERT_TRUE(fine.stages.back().timeStep);
    *fine.stages.back().timeStep *= 0.5;
    RunSettings settings;
    settings.threads = 1;
    auto other = std::async(std::launch::async, [&] { return runInMemory(fine, settings); });
    const std::vector<Failure> failures = failuresOf(runInMemory(coarse, settings));
    EXPECT_EQ(failures.size(), 44u);  // 42 nodes of the rebars, and two D-bolts
    EXPECT_EQ(failures, failuresOf(other.get()));
}

}  // namespace
}  // namespace keyblock
