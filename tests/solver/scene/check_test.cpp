// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes built in code are checked like those from files; what a file cannot
// hold, numbers that are not finite above all, is tried here.
#include "solver/scene/check.h"

#include "solver/scene/lookup.h"
#include "tests/problem_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>

namespace keyblock {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Scene soundScene() {
    Scene scene;
    scene.materials = {{"rock", {2700, 60e9, 0.17}}};
    Block left{.name = "left", .points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .material = "rock",
               .jointMaterial = {}, .subBlocks = {}};
    Block right{.name = "", .points = {{1, 0}, {2, 0}, {2, 1}, {1, 1}}, .material = "rock",
                .jointMaterial = {}, .subBlocks = {}};
    scene.blocks = {left, right};
    scene.supports.resize(1);
    scene.supports[0].blockAt = Point(0.5, 0.5);
    BoltType type;
    type.name = "bar";
    type.youngsModulus = 200e9;
    type.bending = Bending::Elastic;
    scene.boltTypes = {type};
    scene.bolts.resize(1);
    scene.bolts[0].name = "B";
    scene.bolts[0].type = "bar";
    scene.bolts[0].farEnd = {0.1, 0.5};
    scene.bolts[0].head = {1.9, 0.5};
    scene.stages.resize(1);
    scene.stages[0].name = "pull";
    scene.stages[0].motions.resize(1);
    scene.stages[0].motions[0].blockAt = {1.5, 0.5};
    scene.stages[0].motions[0].table = {{0, 0}, {1, 0.001}};
    return scene;
}

/// Shaken by a period of a cosine, which leaves the ground where it was.
Scene shakenScene() {
    Scene scene = soundScene();
    Stage& stage = scene.stages[0];
    stage.kind = StageKind::Dynamic;
    stage.duration = 1.0;
    stage.motions[0].table = {{0, 0}, {1, 0.001}};
    stage.baseAcceleration.emplace();
    for (int i = 0; i <= 100; ++i) stage.baseAcceleration->record.emplace_back(0.01 * i, std::cos(0.062831853 * i));
    return scene;
}

void expectProblem(const std::function<void(Scene&)>& breakIt, const std::string& pointer, Severity severity,
                   Scene scene = soundScene()) {
    breakIt(scene);
    const std::vector<Problem> problems = checkScene(scene);
    EXPECT_TRUE(std::any_of(problems.begin(), problems.end(),
                            [&](const Problem& p) { return p.pointer == pointer && p.severity == severity; }))
        << pointer << "\n" << test::problemList(problems);
}

/// The repair of the problem at the pointer; of kind None if there is no such problem.
Repair repairAt(const std::string& pointer, const Scene& scene) {
    for (const Problem& problem : checkScene(scene))
        if (problem.pointer == pointer) return problem.repair;
    return {};
}

TEST(CheckScene, ExpectsOnlyNumbersThatARunGives) {
    Scene scene = soundScene();
    for (const char* quantity : {"order debonding", "factor_of_safety", "stands", "count debonding", "energy_error"})
        scene.about.expected.push_back({quantity, 1.0, 0.0, "made up"});
    std::vector<std::string> refused;
    for (const Problem& problem : checkScene(scene))
        if (problem.severity == Severity::Error) refused.push_back(problem.pointer);
    EXPECT_EQ(refused, (std::vector<std::string>{"/about/expected/0/quantity", "/about/expected/1/quantity"}));
}

TEST(CheckScene, OffersRepairsThatNeedNoDecision) {
    Scene scene = soundScene();
    scene.blocks[1].name = "left";
    EXPECT_EQ(repairAt("/blocks/1/name", scene), (Repair{RepairKind::Rename, "/blocks/1"}));
    scene = soundScene();
    scene.blocks[0].material = "marble";
    EXPECT_EQ(repairAt("/blocks/0/material", scene), (Repair{RepairKind::AddNamed, "/materials", "marble"}));
    scene = soundScene();
    scene.stages[0].duration = 2.0;
    EXPECT_EQ(repairAt("/stages/0/duration", scene), (Repair{RepairKind::Omit, "/stages/0/duration"}));
    scene = soundScene();
    scene.blocks[0].points.push_back({0, 0});
    EXPECT_EQ(repairAt("/blocks/0/points/4", scene), (Repair{RepairKind::Omit, "/blocks/0/points/4"}));
    scene = soundScene();
    scene.stages.clear();
    EXPECT_EQ(repairAt("", scene), (Repair{RepairKind::AddStage, "/stages"}));
    scene = soundScene();
    scene.bolts[0].type = "bra";  // the right type is the user's choice
    EXPECT_EQ(repairAt("/bolts/0/type", scene), Repair{});
}

TEST(CheckScene, OffersToRemoveAPlateThatIsNotOnRock) {
    Scene scene = soundScene();
    scene.bolts[0].head = {3.9, 0.5};
    scene.bolts[0].plate = PlateKind::Spring;
    EXPECT_EQ(repairAt("/bolts/0/head", scene), (Repair{RepairKind::RemovePlate, "/bolts/0/plate"}));
}

TEST(CheckScene, FindsNothingInASoundScene) {
    EXPECT_TRUE(checkScene(soundScene()).empty()) << test::problemList(checkScene(soundScene()));
}

TEST(CheckScene, BearsNumbersThatAreNotFinite) {
    const auto error = Severity::Error;
    for (const double bad : {nan, infinity, -infinity}) {
        expectProblem([&](Scene& s) { s.blocks[0].points[2].x() = bad; }, "/blocks/0/points", error);
        expectProblem([&](Scene& s) { s.bolts[0].head.y() = bad; }, "/bolts/0/head", error);
        expectProblem([&](Scene& s) { s.stages[0].motions[0].table[1].first = bad; }, "/stages/0/motions/0/table",
                      error);
        expectProblem([&](Scene& s) { s.stages[0].motions[0].axis.x() = bad; }, "/stages/0/motions/0/axis", error);
        expectProblem([&](Scene& s) { s.supports[0].blockAt = Point(bad, 0); }, "/supports/0/block_at", error);
        expectProblem([&](Scene& s) { s.materials[0].second.density = bad; }, "/materials/rock/density", error);
        expectProblem([&](Scene& s) { s.boltTypes[0].steel = {{0, 0}, {0.1, bad}}; }, "/bolt_types/bar/steel", error);
        expectProblem([&](Scene& s) { s.analysis.gravity.y() = bad; }, "/analysis/gravity", error);
    }
}

/// Numbers whose products leave the range of a double let blocks hang in the air.
TEST(CheckScene, RefusesNumbersThatNoSolidCanHave) {
    const auto error = Severity::Error;
    for (const double bad : {1e-300, 1e300}) {
        expectProblem([&](Scene& s) { s.materials[0].second.density = bad; }, "/materials/rock/density", error);
        expectProblem([&](Scene& s) { s.materials[0].second.youngsModulus = bad; }, "/materials/rock/youngs_modulus",
                      error);
        expectProblem([&](Scene& s) { s.analysis.thickness = bad; }, "/analysis/thickness", error);
        expectProblem([&](Scene& s) { s.boltTypes[0].youngsModulus = bad; }, "/bolt_types/bar/youngs_modulus", error);
        expectProblem([&](Scene& s) { s.boltTypes[0].density = bad; }, "/bolt_types/bar/density", error);
    }
    expectProblem([](Scene& s) { s.analysis.gravity.y() = -1e300; }, "/analysis/gravity", error);
}

/// Bounds that hold for every number, whatever its field.
TEST(CheckScene, RefusesNumbersFarBeyondAnyQuantity) {
    const auto error = Severity::Error;
    for (const double bad : {1e308, 5e-324}) {
        const auto dynamic = [&](auto change) {
            return [=](Scene& s) {
                s.stages[0].kind = StageKind::Dynamic;
                s.stages[0].duration = 1.0;
                change(s.stages[0]);
            };
        };
        expectProblem(dynamic([=](Stage& s) { s.duration = bad; }), "/stages/0/duration", error);
        expectProblem(dynamic([=](Stage& s) { s.timeStep = bad; }), "/stages/0/time_step", error);
    }
    expectProblem(
        [](Scene& s) {
            s.stages[0].motions[0].table = {{0, 0}, {1, 1e308}};
        },
        "/stages/0/motions/0/table", error);
    expectProblem([](Scene& s) { s.bolts[0].pretension = 1e200; }, "/bolts/0/pretension", error);
}

TEST(CheckScene, WarnsOfRockUnderTensionInSitu) {
    const auto warning = Severity::Warning;
    expectProblem([](Scene& s) { s.inSituStress = InSituStress{5e6, -5e6, 0.0, {}, 0.0}; }, "/in_situ_stress/sxx", warning);
    expectProblem([](Scene& s) { s.inSituStress = InSituStress{-1e3, -1e3, 0.0, {0.0, 1e5, 0.0}, 0.0}; },
                  "/in_situ_stress/syy", warning);
}

TEST(CheckScene, RefusesASofteningBondThatIsSomethingElseToo) {
    const auto soft = [](Scene& s) -> Anchor& {
        Anchor anchor;
        anchor.law = AnchorLaw::PeakResidual;
        anchor.stiffness = 1e9;
        anchor.strength = 1e5;
        anchor.softeningSlip = 1e-3;
        s.boltTypes[0].anchors = {anchor};
        return s.boltTypes[0].anchors[0];
    };
    Scene sound = soundScene();
    soft(sound);
    EXPECT_TRUE(checkScene(sound).empty()) << test::problemList(checkScene(sound));
    const std::string place = "/bolt_types/bar/anchors/0/softening_slip";
    expectProblem([&](Scene& s) { soft(s).frictionAngle = 20.0; }, place, Severity::Error);
    expectProblem([&](Scene& s) { soft(s).restick = false; }, place, Severity::Error);
    expectProblem([&](Scene& s) { soft(s).softeningSlip = -1e-3; }, place, Severity::Error);
    expectProblem([&](Scene& s) { soft(s).law = AnchorLaw::Frictional; }, place, Severity::Error);
}

TEST(CheckScene, FindsWhatOnlyCodeCanBuild) {
    const auto error = Severity::Error;
    expectProblem([](Scene& s) { s.materials.push_back(s.materials[0]); }, "/materials/rock", error);
    expectProblem([](Scene& s) { s.boltTypes.push_back(s.boltTypes[0]); }, "/bolt_types/bar", error);
    expectProblem([](Scene& s) { s.stages[0].timeStep = 0.1; }, "/stages/0/time_step", error);
    expectProblem([](Scene& s) { s.stages[0].initialVelocities.resize(1); }, "/stages/0/initial_velocities", error);
    expectProblem([](Scene& s) { s.bolts[0].name.clear(); }, "/bolts/0/name", error);
    expectProblem([](Scene& s) { s.blocks[0].name = "b2"; }, "/blocks/1/name", error);
}

TEST(CheckScene, WarnsOfWhatIsProbablyAMistake) {
    const auto warning = Severity::Warning;
    expectProblem([](Scene& s) { s.bolts[0].head = {2.5, 0.5}; }, "/bolts/0/head", warning);
    expectProblem([](Scene& s) { s.stages[0].motions[0].table = {{0, 0}, {2, 1}}; }, "/stages/0/motions/0/table/1",
                  warning);
    expectProblem([](Scene& s) { s.stages.clear(); }, "", warning);
    expectProblem(
        [](Scene& s) {
            s.monitors.resize(1);
            s.monitors[0].name = "m";
            s.monitors[0].between = {Point(0.2, 0.5), Point(0.3, 0.5)};
        },
        "/monitors/0/between", warning);
}

TEST(CheckScene, TellsWhatARecordLeavesBehind) {
    const std::string place = "/stages/0/base_acceleration/record";
    expectProblem([](Scene&) {}, place, Severity::Note, shakenScene());
    const auto drift = [](Scene& s) {
        for (auto& row : s.stages[0].baseAcceleration->record) row.second += 0.1;
    };
    expectProblem(drift, place, Severity::Warning, shakenScene());
}

TEST(CheckScene, WarnsOfShakingThatIsProbablyAMistake) {
    const auto warning = Severity::Warning;
    const std::string base = "/stages/0/base_acceleration";
    expectProblem([](Scene& s) { s.supports.clear(); }, base, warning, shakenScene());
    expectProblem([](Scene& s) { s.stages[0].baseAcceleration->factor = 0.0; }, base + "/factor", warning,
                  shakenScene());
    expectProblem([](Scene& s) { s.stages[0].timeStep = 0.02; }, "/stages/0/time_step", warning, shakenScene());
    expectProblem([](Scene& s) { s.stages[0].duration = 0.5; }, base + "/record", warning, shakenScene());
    const auto late = [](Scene& s) {
        for (auto& row : s.stages[0].baseAcceleration->record) row.first += 2.0;
    };
    expectProblem(late, base + "/record", warning, shakenScene());
}

TEST(CheckScene, BearsAccelerationsThatAreNotFinite) {
    const std::string base = "/stages/0/base_acceleration";
    for (const double bad : {nan, infinity}) {
        expectProblem([&](Scene& s) { s.stages[0].baseAcceleration->record[3].first = bad; }, base + "/record",
                      Severity::Error, shakenScene());
        expectProblem([&](Scene& s) { s.stages[0].baseAcceleration->factor = bad; }, base + "/factor", Severity::Error,
                      shakenScene());
        expectProblem([&](Scene& s) { s.stages[0].baseAcceleration->axis.x() = bad; }, base + "/axis", Severity::Error,
                      shakenScene());
        const auto sine = [&](Scene& s) {
            s.stages[0].baseAcceleration->record.clear();
            s.stages[0].baseAcceleration->sine = Sine{1.0, bad, 0.0};
            s.stages[0].timeStep = 0.1;
        };
        expectProblem(sine, base + "/sine/frequency", Severity::Error, shakenScene());
    }
}

TEST(CheckScene, RefusesRecordsTooLongForAStore) {
    const auto longer = [](Scene& s) {
        s.stages[0].duration = 1e7;
        for (int i = 101; i <= 300'001; ++i) s.stages[0].baseAcceleration->record.emplace_back(0.01 * i, 0.0);
    };
    expectProblem(longer, "/stages", Severity::Error, shakenScene());
}

TEST(CheckScene, WantsAPlateForAPretension) {
    expectProblem(
        [](Scene& s) {
            s.bolts[0].plate = PlateKind::None;
            s.bolts[0].pretension = 1e4;
        },
        "/bolts/0/pretension", Severity::Error);
}

TEST(CheckScene, AcceptsASceneFarFromTheOrigin) {
    Scene scene = soundScene();
    const Point shift(1e6, -1e6);
    for (Block& block : scene.blocks)
        for (Point& point : block.points)
            point += shift;
    *scene.supports[0].blockAt += shift;
    scene.bolts[0].farEnd += shift;
    scene.bolts[0].head += shift;
    scene.stages[0].motions[0].blockAt += shift;
    EXPECT_TRUE(checkScene(scene).empty()) << test::problemList(checkScene(scene));
}

/// Processor time of the check [s].
double secondsOfCheck(const Scene& scene, std::vector<Problem>& problems) {
    const std::clock_t start = std::clock();
    problems = checkScene(scene);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(CheckScene, StopsAtTheMostProblems) {
    Scene crowded = soundScene(), nameless = soundScene();
    crowded.bolts.clear();
    nameless.bolts.clear();
    crowded.blocks.assign(4000, crowded.blocks[0]);
    for (std::size_t i = 0; i < crowded.blocks.size(); ++i) crowded.blocks[i].name = "b" + std::to_string(i);
    for (int i = 0; i < 20000; ++i) {
        nameless.materials.push_back({"granite-" + std::to_string(i), {2700, 60e9, 0.17}});
        Block block = nameless.blocks[0];
        block.name = "b" + std::to_string(i);
        block.material = "granit_" + std::to_string(i);
        for (Point& corner : block.points) corner.x() += 2.0 * (i + 1);
        nameless.blocks.push_back(block);
    }
    for (const Scene* scene : {&crowded, &nameless}) {
        std::vector<Problem> problems;
        EXPECT_LT(secondsOfCheck(*scene, problems), 20.0);  // on any machine: without the limits it takes minutes
        EXPECT_EQ(problems.size(), mostProblems);
    }
}

TEST(CheckScene, RefusesOutlinesOfTooManyCorners) {
    Scene scene = soundScene();
    scene.bolts.clear();
    scene.blocks[1].points.clear();
    for (int i = 0; i < 10001; ++i) {
        const double angle = 2.0 * M_PI * i / 10001;
        scene.blocks[1].points.push_back({5.0 + std::cos(angle), std::sin(angle)});
    }
    const std::vector<Problem> problems = checkScene(scene);
    ASSERT_FALSE(problems.empty());
    EXPECT_EQ(problems[0].pointer, "/blocks/1/points");
    EXPECT_EQ(problems[0].message, "the block has 10001 corners; the limit is 10000");
    scene.blocks[1].points.pop_back();
    for (const Problem& problem : checkScene(scene)) EXPECT_NE(problem.pointer, "/blocks/1/points") << problem.message;
}

TEST(CheckScene, BearsAnEmptyScene) { EXPECT_FALSE(hasErrors(checkScene(Scene{}))); }

}  // namespace
}  // namespace keyblock
