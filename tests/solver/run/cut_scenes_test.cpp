// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes with a domain: what they are cut to, which joint material is on which
// face, and that they come to rest as blocks given one by one do.
#include "solver/engine/setup/make_model.h"
#include "solver/scene/scene_cut.h"

#include "geometry/polygon.h"
#include "solver/run/run.h"
#include "solver/scene/check.h"
#include "solver/scene/lookup.h"
#include "solver/scene/stage_objects.h"
#include "solver/scene/solved_blocks.h"
#include "solver/verify/readings.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace keyblock {
namespace {

using test::line;

Support side(BoundarySide which, Fix fix) {
    Support support;
    support.boundary = which;
    support.fix = fix;
    return support;
}

/// A square of 2 m with a cross in it, on a floor that is held.
Scene crossed() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.domain = SceneDomain{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, scene.materials.front().first, {}};
    scene.joints = {line("level", {-1, 0}, {1, 0}), line("upright", {0, -1}, {0, 1})};
    scene.supports = {side(BoundarySide::Bottom, Fix::XY)};
    scene.analysis.gravity = {0.0, -gravity};
    scene.stages = {test::settle()};
    scene.output.frames = 1;
    return scene;
}

/// Two joint sets and an open d-shaped tunnel in a square of 20 m.
Scene drift() {
    Scene scene = emptyScene(10e9, 0.2, 60.0);
    const double half = 10.0;
    scene.domain =
        SceneDomain{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, scene.materials.front().first, {}};
    SceneJointSet steep, flat;
    steep.name = "steep", steep.dip = 80.0, steep.spacing = 4.0, steep.origin = {1.0, 0.0};
    flat.name = "flat", flat.dip = -5.0, flat.spacing = 4.0, flat.origin = {0.0, 1.0};
    scene.jointSets = {steep, flat};
    SceneTunnel tunnel;
    tunnel.name = "drift", tunnel.profile = ProfileKind::DShape, tunnel.width = 4.0, tunnel.height = 4.0;
    scene.tunnels = {tunnel};
    scene.supports = {side(BoundarySide::Bottom, Fix::XY), side(BoundarySide::Left, Fix::X),
                      side(BoundarySide::Right, Fix::X)};
    scene.analysis.gravity = {0.0, -gravity};
    scene.stages = {test::settle()};
    scene.output.frames = 1;
    return scene;
}

/// Of the drift's polygon [m²].
double areaOf(const SceneTunnel&) {
    // walls 4 × 2 and the polygon of 16 edges that stands for a semicircle of radius 2
    return 4.0 * 2.0 + 16.0 * 0.5 * 4.0 * std::sin(std::numbers::pi / 16.0);
}

std::string errorsOf(const Scene& scene) {
    std::string text;
    for (const Problem& problem : checkScene(scene))
        if (problem.severity == Severity::Error) text += oneLine(problem) + "\n";
    return text;
}

/// Joint materials of the faces through `onFace` of the block that holds `inside`.
std::set<int> jointsOn(const SceneCut& cut, const Point& inside, const Point& onFace) {
    std::set<int> joints;
    const Block& block = cut.scene.blocks.at(static_cast<std::size_t>(blockAt(cut.scene, inside)));
    for (std::size_t e = 0; e < block.points.size(); ++e) {
        const Point &a = block.points[e], &b = block.points[(e + 1) % block.points.size()];
        if (std::abs(cross(b - a, onFace - a)) < 1e-9 * (b - a).norm() && (onFace - a).dot(onFace - b) < 0.0)
            joints.insert(block.faces[e].joint);
    }
    return joints;
}

TEST(CutScene, PartsASquareWithACrossIntoFour) {
    const Scene scene = crossed();
    EXPECT_EQ(errorsOf(scene), "");
    const SceneCut cut = cutScene(scene);
    ASSERT_EQ(cut.scene.blocks.size(), 4u);
    EXPECT_EQ(cut.blocks, 4);
    EXPECT_EQ(cut.vertices, 9);
    EXPECT_NEAR(cut.area, 4.0, 1e-12);
    EXPECT_EQ(blockNames(cut.scene), (std::vector<std::string>{"b1", "b2", "b3", "b4"}));
    for (const Block& block : cut.scene.blocks) EXPECT_NEAR(signedArea(block.points), 1.0, 1e-12);
    EXPECT_EQ(cutScene(cut.scene).scene, cut.scene);
}

/// As in the cut itself.
TEST(CutScene, TakesNoToleranceBelowRoundOff) {
    Scene scene = crossed();
    scene.joints.clear();
    scene.voronoi.emplace().size = 0.5;
    const SceneCut usual = cutScene(scene);
    EXPECT_EQ(usual.blocks, 16);
    scene.cutting.tolerance = 1e-30;
    EXPECT_EQ(errorsOf(scene), "");
    EXPECT_EQ(cutScene(scene).blocks, usual.blocks);
}

TEST(CutScene, DoesNotDependOnTheOrderOfJoints) {
    Scene scene = crossed(), turned = scene;
    std::swap(turned.joints[0], turned.joints[1]);
    std::reverse(turned.joints[0].points.begin(), turned.joints[0].points.end());
    const SceneCut first = cutScene(scene), second = cutScene(turned);
    ASSERT_EQ(first.scene.blocks.size(), second.scene.blocks.size());
    for (std::size_t b = 0; b < first.scene.blocks.size(); ++b)
        EXPECT_EQ(first.scene.blocks[b].points, second.scene.blocks[b].points);
}

TEST(CutScene, SettlesUnderItsWeight) {
    const Solved solved = solve(crossed());
    ASSERT_EQ(solved.results.stages.size(), 1u);
    EXPECT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    const Frame& frame = solved.results.frames.back();
    double weight = 0.0, floor = 0.0;
    for (const BlockState& block : frame.blocks) weight += block.weight;
    for (const ContactFrame& contact : frame.contacts)
        if (std::abs(contact.position.y()) < 1e-3) floor += contact.normalForce;
    EXPECT_NEAR(floor, 0.5 * weight, 1e-3 * weight);  // the upper half stands on the lower
}

TEST(CutScene, SettlesAsTheSameBlocksOneByOne) {
    const Scene scene = crossed();
    Scene blocks = cutScene(scene).scene;
    for (Block& block : blocks.blocks) block.faces.clear();
    blocks.supports.clear();
    for (double x : {-1.0, 0.0, 1.0})
        for (double y : {-1.0}) {
            Support support;
            support.point = Point(x == 0.0 ? -1e-6 : x, y);
            support.fix = Fix::XY;
            blocks.supports.push_back(support);
        }
    blocks.supports.push_back(blocks.supports.back());
    blocks.supports.back().point = Point(1e-6, -1.0);
    const Solved one = solve(scene), other = solve(blocks);
    const Frame &a = one.results.frames.back(), &b = other.results.frames.back();
    ASSERT_EQ(a.blocks.size(), b.blocks.size());
    for (std::size_t i = 0; i < a.blocks.size(); ++i)
        EXPECT_NEAR((a.blocks[i].displacement - b.blocks[i].displacement).norm(), 0.0,
                    1e-3 * a.blocks[i].displacement.norm());
}

TEST(CutScene, GivesEveryFaceTheMaterialOfItsTrace) {
    Scene scene = crossed();
    scene.jointMaterials = {{"rough", {}}, {"weak", {}}, {"edge", {}}};
    scene.jointMaterials[0].second.frictionAngle = 40.0;
    scene.jointMaterials[1].second.frictionAngle = 10.0;
    scene.joints[0].jointMaterial = "weak";
    scene.domain->jointMaterial = "edge";
    const SceneCut cut = cutScene(scene);
    EXPECT_EQ(jointsOn(cut, {0.5, 0.5}, {0.5, 0.0}), (std::set<int>{1}));
    EXPECT_EQ(jointsOn(cut, {0.5, -0.5}, {0.5, 0.0}), (std::set<int>{1}));
    EXPECT_EQ(jointsOn(cut, {0.5, 0.5}, {0.0, 0.5}), (std::set<int>{2}));  // names none: the domain's
    EXPECT_EQ(jointsOn(cut, {0.5, 0.5}, {1.0, 0.5}), (std::set<int>{2}));
    const Solved solved = solve(scene);
    for (const ContactFrame& contact : solved.results.frames.back().contacts) {
        const bool level = std::abs(contact.position.y()) < 1e-3;
        const bool middle = level && std::abs(contact.position.x()) < 1e-3;
        if (!middle) {
            EXPECT_EQ(contact.jointMaterial, level ? 1 : 2) << contact.position.transpose();
        }
    }
}

TEST(CutScene, LeavesAnOpenTunnelOut) {
    const Scene scene = drift();
    EXPECT_EQ(errorsOf(scene), "");
    const SceneCut cut = cutScene(scene);
    double area = 0.0;
    for (const Block& block : cut.scene.blocks) area += signedArea(block.points);
    EXPECT_NEAR(area, 400.0 - areaOf(scene.tunnels[0]), 1e-9);
    EXPECT_NEAR(cut.area, area, 1e-9);
    EXPECT_GT(cut.open, 0);
    EXPECT_LT(blockAt(cut.scene, {0.0, 0.1}), 0);
    EXPECT_GT(cut.scene.blocks.size(), 20u);
}

TEST(CutScene, SettlesRoundAnOpenTunnel) {
    const Solved solved = solve(drift());
    ASSERT_EQ(solved.results.stages.size(), 1u);
    EXPECT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium) << solved.results.stages[0].message;
    for (const BlockState& block : solved.results.frames.back().blocks) {
        EXPECT_TRUE(block.centroid.allFinite());
        for (double stress : block.stress) EXPECT_TRUE(std::isfinite(stress));
    }
}

TEST(CutScene, PartsABlockRoundAnOpeningByIntactFaces) {
    Scene scene = drift();
    scene.jointSets.clear();
    const SceneCut cut = cutScene(scene);
    EXPECT_EQ(cut.scene.blocks.size(), 2u);
    EXPECT_EQ(cut.split, 2);
    double area = 0.0;
    for (const Block& block : cut.scene.blocks) {
        area += signedArea(block.points);
        EXPECT_FALSE(crossesItself(block.points, 1e-9));
        EXPECT_EQ(std::count_if(block.faces.begin(), block.faces.end(),
                                [](const CutFace& face) { return face.joint == intactJoint && !face.side; }) > 2, true);
    }
    EXPECT_NEAR(area, 400.0 - areaOf(scene.tunnels[0]), 1e-9);
    // held together where they were parted: the upper half would else slide down if it were pushed along
    scene.supports = {side(BoundarySide::Bottom, Fix::XY)};
    scene.analysis.gravity = {40.0 * gravity, 0.0};
    const Solved solved = solve(scene);
    EXPECT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    int bonded = 0;
    for (const ContactFrame& contact : solved.results.frames.back().contacts)
        if (contact.jointMaterial == intactJoint) bonded += contact.state == ContactState::Bonded;
    EXPECT_GE(bonded, 4);
}

TEST(CutScene, HoldsEveryCornerOnASideOnce) {
    Scene scene = crossed();
    scene.supports.push_back(side(BoundarySide::Left, Fix::X));
    const Model model = makeModel(cutScene(scene).scene);
    EXPECT_EQ(model.supports.size(), 4u + 3u);  // four at the bottom; of the left side's four one is held there already
    scene.supports = {side(BoundarySide::Bottom, Fix::All)};
    const Model fixed = makeModel(cutScene(scene).scene);
    EXPECT_EQ(std::count_if(fixed.blocks.begin(), fixed.blocks.end(), [](const BlockModel& b) { return b.fixed; }), 2);
}

TEST(CutScene, PutsExplicitBlocksFirst) {
    Scene scene = crossed();
    scene.blocks = {boxBlock("", {2, -1}, {3, 1})};
    EXPECT_EQ(errorsOf(scene), "");
    const SceneCut cut = cutScene(scene);
    EXPECT_EQ(blockNames(cut.scene), (std::vector<std::string>{"b1", "b2", "b3", "b4", "b5"}));
    EXPECT_TRUE(cut.scene.blocks[0].faces.empty());
    EXPECT_NEAR(signedArea(cut.scene.blocks[0].points), 2.0, 1e-12);
}

TEST(CutScene, LaysPatternsOutFromTheWall) {
    Scene scene = drift();
    scene.boltTypes = {linearType(barArea(), 200e9)};
    ScenePattern pattern;
    pattern.name = "P", pattern.type = scene.boltTypes[0].name, pattern.tunnel = "drift";
    pattern.from = {2.0, 0.0}, pattern.to = {-2.0, 0.0}, pattern.spacing = std::numbers::pi / 2.0, pattern.length = 2.4;
    scene.boltPatterns = {pattern};
    EXPECT_EQ(errorsOf(scene), "");
    const SceneCut cut = cutScene(scene);
    ASSERT_EQ(cut.scene.bolts.size(), 5u);  // half the crown's circle is 2π
    EXPECT_EQ(cut.scene.bolts[0].name, "P.1");
    EXPECT_EQ(cut.scene.bolts[4].name, "P.5");
    EXPECT_NEAR((cut.scene.bolts[2].head - Point(0.0, 2.0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((cut.scene.bolts[2].farEnd - Point(0.0, 4.4)).norm(), 0.0, 1e-9);
    for (const Bolt& bolt : cut.scene.bolts) {
        EXPECT_NEAR(lengthOf(bolt), 2.4, 1e-9);
        EXPECT_EQ(bolt.pattern, 0);
        EXPECT_GE(blockWithPoint(cut.scene, bolt.head), 0);
    }
}

TEST(CutScene, KeepsATunnelUntilItIsExcavated) {
    Scene scene = drift();
    scene.jointSets.clear();
    scene.boltTypes = {linearType(barArea(), 200e9)};
    ScenePattern pattern;
    pattern.name = "P", pattern.type = scene.boltTypes[0].name, pattern.tunnel = "drift";
    pattern.from = {2.0, 0.0}, pattern.to = {-2.0, 0.0}, pattern.spacing = std::numbers::pi / 2.0, pattern.length = 2.4;
    scene.boltPatterns = {pattern};
    scene.stages.push_back(test::settle());
    scene.stages[1].name = "excavate";
    scene.stages[1].excavate = {"drift"};
    scene.stages[1].install = {"P"};
    EXPECT_EQ(errorsOf(scene), "");
    const SceneCut cut = cutScene(scene);
    EXPECT_NEAR(cut.area, 400.0, 1e-9);
    EXPECT_EQ(cut.open, 0);
    const std::vector<int> gone = excavatedBlocks(cut.scene, scene.stages[1]);
    ASSERT_EQ(gone.size(), 1u);
    EXPECT_NEAR(signedArea(cut.scene.blocks[gone[0]].points), areaOf(scene.tunnels[0]),
                1e-9);
    EXPECT_EQ(boltsNamed(cut.scene, "P").size(), 5u);
    EXPECT_EQ(boltsNamed(cut.scene, "P.3"), (std::vector<int>{2}));
    for (const Bolt& bolt : cut.scene.bolts) EXPECT_TRUE(isInstalledLater(cut.scene, bolt));
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.size(), 2u);
    for (const StageResult& stage : solved.results.stages) EXPECT_EQ(stage.outcome, Outcome::Equilibrium);
}

/// Through joints, which are bonded: what goes is the profile, to the last sliver, and what stays comes to rest.
TEST(CutScene, ExcavatesATunnelThroughJointSets) {
    Scene scene = drift();
    scene.jointMaterials[0].second.cohesion = scene.jointMaterials[0].second.tensileStrength = 1e9;
    scene.stages.push_back(test::settle());
    scene.stages[1].name = "excavate";
    scene.stages[1].excavate = {"drift"};
    scene.stages[1].increments = 4;
    EXPECT_EQ(errorsOf(scene), "");
    const SceneCut cut = cutScene(scene);
    EXPECT_NEAR(cut.area, 400.0, 1e-9);
    const std::vector<int> gone = excavatedBlocks(cut.scene, scene.stages[1]);
    EXPECT_GT(gone.size(), 1u);
    double area = 0.0;
    for (int block : gone) area += signedArea(cut.scene.blocks[block].points);
    EXPECT_NEAR(area, areaOf(scene.tunnels[0]), 1e-9);
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.size(), 2u);
    for (const StageResult& stage : solved.results.stages) {
        EXPECT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
        EXPECT_LT(std::abs(stage.health.balanceError), 1e-3);
    }
    const Frame& last = solved.results.frames.back();
    for (int block : gone)
        for (const ContactFrame& contact : last.contacts)
            EXPECT_TRUE(contact.blockA != block && contact.blockB != block) << block;
}

/// A pilot that is widened: in whichever order the two are listed, each takes what is left of it when its turn comes.
TEST(CutScene, RockInTwoTunnelsGoesWithTheFirstThatIsExcavated) {
    Scene scene = drift();
    scene.jointSets.clear();
    SceneTunnel pilot = scene.tunnels[0];
    pilot.name = "pilot", pilot.width = 2.0, pilot.height = 2.0, pilot.center = scene.tunnels[0].center;
    scene.stages = {test::settle(), test::settle(), test::settle()};
    scene.stages[1].name = "pilot", scene.stages[1].excavate = {"pilot"};
    scene.stages[2].name = "widen", scene.stages[2].excavate = {"drift"};
    scene.stages[1].increments = scene.stages[2].increments = 4;
    for (const bool pilotFirst : {true, false}) {
        Scene both = scene;
        both.tunnels.insert(pilotFirst ? both.tunnels.begin() : both.tunnels.end(), pilot);
        EXPECT_EQ(errorsOf(both), "");
        const SceneCut cut = cutScene(both);
        const auto areaOfAll = [&](const Stage& stage) {
            double area = 0.0;
            for (int block : excavatedBlocks(cut.scene, stage))
                area += signedArea(cut.scene.blocks[block].points);
            return area;
        };
        EXPECT_NEAR(areaOfAll(both.stages[1]), 0.25 * areaOf(scene.tunnels[0]), 1e-9);  // of half its size
        EXPECT_NEAR(areaOfAll(both.stages[2]), areaOf(scene.tunnels[0]), 1e-9);
        const Solved solved = solve(both);
        ASSERT_EQ(solved.results.stages.size(), 3u);
        for (const StageResult& stage : solved.results.stages)
            EXPECT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
        EXPECT_LT(std::abs(solved.results.stages[2].health.balanceError), 1e-3);
    }
}

TEST(CutScene, MakesTheSameBytesAgain) {
    Scene scene = drift();
    scene.jointSets[0].spacingDeviation = 1.0;
    const SceneCut first = cutScene(scene), second = cutScene(scene);
    EXPECT_EQ(first.scene, second.scene);
}

/// Two sets in a square that is held at its sides and foot, some 100 blocks.
Scene jointed(double friction) {
    Scene scene = drift();
    scene.tunnels.clear();
    for (SceneJointSet& set : scene.jointSets) set.spacing = 2.0;
    scene.jointMaterials.front().second.frictionAngle = friction;
    return scene;
}

/// From cold and by the defaults, whatever the friction; energy closes.
TEST(JointedRock, SettlesUnderItsWeight) {
    for (const double friction : {20.0, 30.0, 60.0}) {
        SCOPED_TRACE(friction);
        const Scene scene = jointed(friction);
        const Results results = runInMemory(scene);
        ASSERT_EQ(results.stages.size(), 1u);
        EXPECT_EQ(results.stages[0].outcome, Outcome::Equilibrium);
        EXPECT_LT(std::abs(results.frames.back().energy.balanceError), 1e-2);
    }
}

/// A thousand cells of 1 m².
TEST(JointedRock, AThousandCellsSettle) {
    Scene scene = drift();
    scene.tunnels.clear();
    scene.jointSets.clear();
    const double half = 16.0;
    scene.domain->boundary = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    SceneVoronoi cells;
    cells.size = 1.0;
    scene.voronoi = cells;
    scene.jointMaterials.front().second.frictionAngle = 30.0;
    const Results results = runInMemory(scene);
    ASSERT_GT(results.frames.back().blocks.size(), 900u);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Equilibrium);
    EXPECT_LT(std::abs(results.frames.back().energy.balanceError), 1e-2);
}

/// Rock of 10 m under stress, held all round, with a room of 4 m in it, on whose floor lies a block of 1 m.
Scene blockInRoom() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.domain = SceneDomain{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, scene.materials.front().first, {}};
    SceneTunnel room;
    room.name = "room";
    room.profile = ProfileKind::Polygon;
    room.points = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
    scene.tunnels = {room};
    for (const BoundarySide each : {BoundarySide::Bottom, BoundarySide::Top, BoundarySide::Left, BoundarySide::Right})
        scene.supports.push_back(side(each, Fix::All));
    scene.blocks = {boxBlock("loose", {-0.5, -2}, {0.5, -1})};
    scene.analysis.gravity = {0.0, -gravity};
    scene.inSituStress = InSituStress{-1e6, -1e6, 0.0, {}, 0.0};
    scene.stages = {test::settle()};
    return scene;
}

bool isRefused(const Scene& scene) {
    const std::vector<Problem> problems = checkScene(scene);
    return std::any_of(problems.begin(), problems.end(), [](const Problem& problem) {
        return problem.severity == Severity::Error && problem.pointer == "/blocks/0";
    });
}

TEST(CutScenes, ABlockMayStandInATunnelThatIsOpen) {
    EXPECT_FALSE(isRefused(blockInRoom()));
    Scene later = blockInRoom();
    later.stages[0].excavate = {"room"};
    EXPECT_TRUE(isRefused(later));
    Scene across = blockInRoom();
    across.blocks[0] = boxBlock("loose", {-0.5, -2.5}, {0.5, -1});
    EXPECT_TRUE(isRefused(across));
}

TEST(CutScenes, ABlockInAnOpeningBearsItsWeightAndNoStressInSitu) {
    const Solved solved = solve(blockInRoom());
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium) << solved.results.stages[0].message;
    const double weight = solved.scene.materials.front().second.density * gravity;
    double carried = 0.0;
    for (const ContactFrame& contact : solved.results.frames.back().contacts)
        if (contact.blockA == 0 || contact.blockB == 0) carried += contact.normalForce;
    EXPECT_NEAR(carried, weight, 1e-3 * weight);
    EXPECT_NEAR(solved.results.frames.back().blocks[0].stress[1], -0.5 * weight, 1e-2 * weight);
    const double confined = 0.2 / (1.0 - 0.2) * 0.5 * weight;  // where the floor's friction held it altogether
    EXPECT_LE(std::abs(solved.results.frames.back().blocks[0].stress[0]), confined);
}

}  // namespace
}  // namespace keyblock
