// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers grow with the frame, so that no two frames are the same.
#include "tests/solver/results/sample_run.h"

#include "solver/results/history.h"

namespace keyblock::test {

namespace {

Block square(const std::string& name, double left) {
    Block block;
    block.name = name;
    block.points = {{left, 0.0}, {left + 1.0, 0.0}, {left + 1.0, 1.0}, {left, 1.0}};
    block.material = "rock";
    return block;
}

BoltType plainBar() {
    BoltType type;
    type.name = "plain bar";
    type.source = "made up";
    type.youngsModulus = 200e9;
    type.normalStiffness = 5e9;
    Anchor anchor;
    anchor.per = Per::Node;
    anchor.stiffness = 1e8;
    type.anchors = {anchor};
    return type;
}

Stage stage(const std::string& name, StageKind kind) {
    Stage result;
    result.name = name;
    result.kind = kind;
    if (kind == StageKind::Dynamic)
        result.duration = 2.0;
    return result;
}

std::vector<Monitor> monitors() {
    std::vector<Monitor> list(3);
    list[0].name = "crown";
    list[0].point = Point{0.5, 1.0};
    list[1].name = "opening";
    list[1].between = std::array{Point{0.9, 0.5}, Point{1.1, 0.5}};
    list[2].name = "joint force";
    list[2].bolt = "B, \"1\"";
    list[2].at = 0.4;
    return list;
}

Event debonding() {
    Event event;
    event.time = 0.3;
    event.step = 3;
    event.kind = EventKind::Debonding;
    event.bolt = 0;
    event.node = 1;
    event.block = 1;
    event.position = {1.1, 0.5};
    event.axialForce = 1e5 / 3.0;
    event.shearForce = -1e-300;
    event.anchorForce = 24560.0;
    event.slip = 2.9e-4;
    event.historyRow = 1;
    return event;
}

Event jointOpen() {
    Event event;
    event.time = 0.3;
    event.step = 3;
    event.kind = EventKind::JointOpen;
    event.block = 0;
    event.otherBlock = 1;
    event.position = {1.0, 0.5};
    event.historyRow = 3;
    event.cause = 0;
    return event;
}

BlockState blockState(double left, double grown) {
    BlockState state;
    state.centroid = {left + 0.5 + grown, 0.5};
    state.displacement = {grown, -grown / 7.0};
    state.rotation = 1e-3 * grown;
    state.stress = {1e6 * grown, -2e6 * grown, 3e5 * grown};
    state.velocity = {0.1 * grown, 0.0};
    state.area = 1.0;
    state.weight = 26487.0;
    state.points = {{left + grown, 0.0}, {left + 1.0 + grown, 0.0}, {left + 1.0 + grown, 1.0}, {left + grown, 1.0}};
    return state;
}

ContactFrame contact(double grown) {
    ContactFrame frame;
    frame.blockA = 0;
    frame.blockB = 1;
    frame.jointMaterial = 0;
    frame.position = {1.0, 0.25};
    frame.normal = {0.6, -0.8};
    frame.state = ContactState::Sliding;
    frame.normalForce = 1e3 * grown;
    frame.shearForce = 4e2 * grown;
    frame.penetration = 1e-6 * grown;
    frame.slip = 1e-4;
    return frame;
}

BoltFrame boltFrame(double grown) {
    BoltFrame bolt;
    bolt.nodes.resize(3);
    for (int node = 0; node < 3; ++node) {
        BoltNodeFrame& n = bolt.nodes[node];
        n.s = 0.4 * node;
        n.position = {0.6 + n.s + grown, 0.5};
        n.block = node == 1 ? -1 : node / 2;
        n.real = node != 1;
        n.state = node == 1 ? NodeState::Free : NodeState::Slipping;
        n.axialForce = 1e5 * grown / (node + 3.0);
        n.moment = 12.5 * node;
        n.anchorForce = -2e3 * grown;
        n.slip = 1e-5 * node;
        n.bondStrength = n.real ? 25e3 : 0.0;
        n.bondResidual = 4e3 * node;
        n.ruptured = node == 0;
    }
    bolt.plateHolds = true;
    bolt.lost = grown > 0.05;
    bolt.elasticEnergy = 1.5 * grown;
    bolt.plasticEnergy = 2.5 * grown;
    bolt.bondEnergy = 3.5 * grown;
    return bolt;
}

/// As of a frame at rest, or in motion: then contacts have a row of their own.
FrameForces forces(bool moves, double grown) {
    FrameForces all;
    all.bodies = {{{0.0, -26487.0}, {0.0, 0.0}, 0.0}, {{0.0, -26487.0}, {1e2 * grown, 2e2 * grown}, -grown}};
    if (moves) all.contacts = {{{5e2 * grown, -6e2 * grown}, 12.5, -0.1}};
    all.nodes = {{1e3 * grown, -7.5}, {0.0, 0.0}, {-2e3 * grown, 0.5}};
    all.others = {{0, ForceSource::Support, -1, {0.5, 0.0}, {0.0, 3e4}, 0.25},
                  {1, ForceSource::Bolt, 0, {1.4, 0.5}, {-1e4 * grown, 0.0}, 0.0},
                  {0, ForceSource::Glue, 1, {1.0, 0.5}, {8.0, 4.0}, 3.0}};
    return all;
}

BoltExtremes extremes(int stage, double grown) {
    BoltExtremes bolt;
    bolt.axialForce = {-1e5 * grown, 0.2, stage, 0.25};
    bolt.shearForce = {2e3 * grown, 0.6, stage, 0.5};
    bolt.moment = {12.5, 0.4, 0, 1.0 / 3.0};
    bolt.steel = {0.5 * grown, 0.2, stage, 0.25};
    bolt.shear = {0.25 * grown, 0.6, stage, 0.5};
    bolt.bond = {0.8, 0.0, 0, 1.0 / 3.0};
    bolt.plate.value = -1.0;
    return bolt;
}

BlockExtremes blockExtremes(int stage, double grown) {
    return {{2e-3 * grown, stage, 0.25}, {0.5 * grown, 0, 0.5}, {3e5 * grown, stage, 1.0 / 3.0}, {}};
}

Frame frame(int stage, double time, long step) {
    const double grown = 0.01 * static_cast<double>(step);
    Frame result;
    result.stage = stage;
    result.time = time;
    result.step = step;
    result.blocks = {blockState(0.0, grown), blockState(1.0, grown)};
    if (step > 1)
        result.contacts = {contact(grown)};
    result.bolts = {boltFrame(grown)};
    result.energy = {grown, 2 * grown, 3 * grown, 4 * grown, 5 * grown, 6 * grown, 7 * grown, 8 * grown, 9 * grown,
                     1e-12};
    result.forces = forces(stage == 1, grown);
    result.extremes = {extremes(stage, grown)};
    result.blockExtremes = {blockExtremes(stage, grown), blockExtremes(0, 2.0 * grown)};
    return result;
}

HistoryRow row(const Scene& scene, int stage, double time, long step, double base) {
    HistoryRow result{stage, time, step, {}};
    for (std::size_t column = 0; column < historyColumns(scene).names.size(); ++column)
        result.values.push_back(base + static_cast<double>(column));
    return result;
}

StageResult ended(int stage, Outcome outcome, double time, long steps) {
    StageResult result;
    result.stage = stage;
    result.outcome = outcome;
    result.time = time;
    result.steps = steps;
    const StepWork work{2 * steps, steps, 5, 4 * steps, 9 * steps, 7};
    result.health = {steps, 3 * steps, 1, 2, work, 40 * steps, 50 * steps, 1e-7, 9e-5, 1e-6, {stage, 1e-4, 3.5}};
    result.farthest = {1, Movement::Falls, 0.25, 2e4};
    if (outcome != Outcome::Equilibrium) result.unstable = {result.farthest, {0, Movement::Follows, 0.1, 3e4}};
    result.loose = {stage};
    return result;
}

}  // namespace

Scene sampleScene() {
    Scene scene;
    scene.title = "Two blocks and a bolt";
    scene.analysis.plane = Plane::Stress;
    scene.materials = {{"rock", {2700.0, 60e9, 0.17}}};
    JointMaterial joint;
    joint.frictionAngle = 30.0;
    scene.jointMaterials = {{"joint", joint}};
    scene.blocks = {square("left", 0.0), square("", 1.0)};
    Support support;
    support.blockAt = Point{0.5, 0.1};
    scene.supports = {support};
    scene.boltTypes = {plainBar()};
    scene.bolts.resize(1);
    scene.bolts[0].name = "B, \"1\"";
    scene.bolts[0].type = "plain bar";
    scene.bolts[0].farEnd = {0.6, 0.5};
    scene.bolts[0].head = {1.4, 0.5};
    scene.bolts[0].divisions = 2;
    scene.stages = {stage("pull", StageKind::Static), stage("shake: hard", StageKind::Dynamic)};
    scene.monitors = monitors();
    scene.quantities = {"max opening", "first debonding joint force"};
    return scene;
}

Results sampleResults() {
    const Scene scene = sampleScene();
    Results results;
    results.columns = historyColumns(scene);
    results.events = {debonding(), jointOpen()};
    results.history = {row(scene, 0, 0.0, 0, 0.0),   row(scene, 0, 0.3, 3, 100.0), row(scene, 0, 0.3, 3, 200.0),
                       row(scene, 0, 0.3, 3, 300.0), row(scene, 0, 0.3, 3, 250.0), row(scene, 0, 1.0, 5, 50.0),
                       row(scene, 1, 0.5, 6, 60.0),  row(scene, 1, 2.0, 9, 90.0)};
    results.frames = {frame(0, 0.0, 0), frame(0, 1.0, 5), frame(1, 0.5, 6), frame(1, 2.0, 9)};
    for (std::size_t f = 1; f < results.frames.size(); ++f) results.frames[f].events = 2;
    results.stages = {ended(0, Outcome::Equilibrium, 1.0, 5), ended(1, Outcome::Duration, 2.0, 4)};
    results.stages[0].message = "left moves";
    results.stages[0].blocks = {0, 1};
    return results;
}

void feed(const Scene& scene, const Results& results, Sink& sink) {
    const auto upTo = [](const auto& item, const Frame& frame) {
        return item.stage < frame.stage || (item.stage == frame.stage && item.time <= frame.time);
    };
    const auto isNext = [](const Event& item, std::size_t row) {
        return static_cast<std::size_t>(item.historyRow) == row;
    };
    sink.begin(scene, results.columns);
    std::size_t event = 0;
    std::size_t history = 0;
    std::size_t next = 0;
    for (const StageResult& stage : results.stages) {
        sink.stageBegins(stage.stage);
        for (; next < results.frames.size() && results.frames[next].stage == stage.stage; ++next) {
            const Frame& frame = results.frames[next];
            for (; history < results.history.size() && upTo(results.history[history], frame); ++history) {
                sink.history(results.history[history]);
                for (; event < results.events.size() && isNext(results.events[event], history); ++event)
                    sink.event(results.events[event]);
            }
            sink.frame(frame);
        }
        sink.stageEnds(stage);
    }
}

}  // namespace keyblock::test
