// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/properties/odd_scene.h"

#include "geometry/polygon.h"
#include "solver/run/model_summary.h"
#include "solver/run/run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace keyblock::test {
namespace {

constexpr std::string_view drift = R"({
  "format": "keyblock-scene", "version": 1,
  "analysis": {"gravity": [0, -9.81]},
  "materials": {"rock": {"density": 2700, "youngs_modulus": 10e9, "poissons_ratio": 0.2}},
  "joint_materials": {"joint": {"friction_angle": 35}},
  "domain": {"boundary": [[-4, -3], [4, -3], [4, 3], [-4, 3]], "material": "rock"},
  "joints": [{"name": "level", "points": [[-4, 1.5], [4, 1.5]]}],
  "joint_sets": [{"name": "steep", "dip": 80, "spacing": 2.5, "origin": [0.3, 0]}],
  "tunnels": [{"name": "drift", "profile": "circle", "center": [0, -0.5], "diameter": 2}],
  "bolt_patterns": [{"name": "roof", "type": "d-bolt-20", "tunnel": "drift", "from": [1, 0], "to": [-1, 0],
                     "spacing": 1, "length": 2.2, "divisions": 22}],
  "supports": [{"boundary": "bottom", "fix": "xy"}, {"boundary": "left", "fix": "x"},
               {"boundary": "right", "fix": "x"}],
  "in_situ_stress": {"gradient_y": {"sxx": 13243.5, "syy": 26487}, "reference_y": 3},
  "stages": [{"name": "settle"}, {"name": "excavate", "excavate": ["drift"], "relaxation": 0.5, "increments": 10},
             {"name": "bolt", "install": ["roof"], "relaxation": 1, "increments": 10}],
  "output": {"frames": 3}
})";

const OddRun& plain() {
    static const OddRun run = runOddScene("{}");
    return run;
}

void expectFinite(const Results& results) {
    for (const Frame& frame : results.frames) {
        for (const BlockState& block : frame.blocks) {
            EXPECT_TRUE(block.centroid.allFinite() && block.velocity.allFinite());
            for (double stress : block.stress) EXPECT_TRUE(std::isfinite(stress));
        }
        for (const BoltFrame& bolt : frame.bolts)
            for (const BoltNodeFrame& node : bolt.nodes)
                EXPECT_TRUE(node.position.allFinite() && std::isfinite(node.axialForce + node.moment + node.slip));
    }
}

char letterOf(Outcome outcome) {
    switch (outcome) {
        case Outcome::Equilibrium: return 'e';
        case Outcome::Duration: return 'd';
        case Outcome::Collapse: return 'c';
        default: return '?';
    }
}

void expectNoRockLost(const OddRun& run, double expected) {
    double area = 0.0;
    for (const Block& block : run.solved().blocks) area += signedArea(block.points);
    EXPECT_NEAR(area, expected, 1e-9 * expected);
    EXPECT_NEAR(run.reading.cut->area, area, 1e-9 * area);
}

void expectCounted(const OddRun& run) {
    const ModelSummary summary = *makeModelSummary(run.solved(), &*run.reading.cut);
    EXPECT_EQ(summary.counts.blocks, static_cast<int>(run.solved().blocks.size()));
    EXPECT_EQ(summary.counts.bolts, static_cast<int>(run.solved().bolts.size()));
}

void expectEnds(const Results& results, const std::string& expected) {
    std::string ends;
    for (const StageResult& stage : results.stages) {
        const bool collapsed = stage.outcome == Outcome::Collapse;
        ends += letterOf(stage.outcome);
        EXPECT_EQ(stage.message.empty(), !collapsed) << stage.message;
        if (!collapsed) {
            EXPECT_LT(std::abs(stage.health.balanceError), 1e-2) << stage.stage;
        }
    }
    EXPECT_EQ(ends, expected);
}

}  // namespace

SceneReading oddScene(std::string_view patch) {
    nlohmann::json scene = nlohmann::json::parse(drift);
    scene.merge_patch(nlohmann::json::parse(patch));
    return readSceneText(scene.dump(), "odd");
}

OddRun runOddScene(std::string_view patch) {
    OddRun run;
    run.reading = oddScene(patch);
    RunSettings settings;
    if (run.reading.cut) settings.cut = &*run.reading.cut;
    if (run.reading.scene) run.results = runInMemory(*run.reading.scene, settings);
    return run;
}

void PrintTo(const Odd& scene, std::ostream* out) { *out << scene.name; }

void expectRuns(const Odd& scene) {
    const OddRun run = runOddScene(scene.patch);
    ASSERT_TRUE(run.reading.scene) << listing(run.reading);
    expectNoRockLost(run, scene.area);
    expectCounted(run);
    expectEnds(run.results, scene.ends);
    expectFinite(run.results);
    if (scene.holds && !testing::Test::HasFailure()) scene.holds(run);
}

void asPlain(const OddRun& run) {
    const Frame &a = plain().results.frames.back(), &b = run.results.frames.back();
    ASSERT_EQ(a.blocks.size(), b.blocks.size());
    for (std::size_t i = 0; i < a.blocks.size(); ++i)
        EXPECT_NEAR((a.blocks[i].displacement - b.blocks[i].displacement).norm(), 0.0, 1e-3 * largestMove(a)) << i;
}

void nothingMoves(const OddRun& run) {
    for (const Frame& frame : run.results.frames) EXPECT_LT(largestMove(frame), 1e-9);
    EXPECT_TRUE(run.results.events.empty());
}

void lastIsIdle(const OddRun& run) {
    const int last = static_cast<int>(run.results.stages.size()) - 1;
    const Frame &before = endOf(run.results, last - 1), &after = endOf(run.results, last);
    for (std::size_t i = 0; i < before.blocks.size(); ++i)
        EXPECT_LT((before.blocks[i].displacement - after.blocks[i].displacement).norm(), 1e-9) << i;
}

std::string listing(const SceneReading& reading) {
    std::string text;
    for (const Problem& problem : reading.problems) text += oneLine(problem) + "\n";
    return text;
}

bool warns(const SceneReading& reading, std::string_view word) {
    return std::any_of(reading.problems.begin(), reading.problems.end(), [&](const Problem& problem) {
        return problem.severity == Severity::Warning &&
               (problem.message + problem.remedy).find(word) != std::string::npos;
    });
}

bool notes(const SceneReading& reading, CutNoteKind kind) {
    return reading.cut && std::any_of(reading.cut->notes.begin(), reading.cut->notes.end(),
                                      [&](const CutNote& note) { return note.kind == kind; });
}

double largestMove(const Frame& frame) {
    double most = 0.0;
    for (const BlockState& block : frame.blocks)
        if (block.area > 0.0) most = std::max(most, block.displacement.norm());
    return most;
}

const Frame& endOf(const Results& results, int stage) {
    const Frame* last = nullptr;
    for (const Frame& frame : results.frames)
        if (frame.stage == stage) last = &frame;
    return *last;
}

}  // namespace keyblock::test
