// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two bricks on a slab and a bolt through them, with results made up so that a
// hand can check what is drawn of them.
#pragma once

#include "solver/results/frame_quantities.h"
#include "solver/results/run_source.h"
#include "ui/picture/section/section.h"

#include <cmath>
#include <string>

namespace keyblock::test {

inline Block brick(const std::string& name, double x, double y, double width, double height) {
    Block block;
    block.name = name;
    block.points = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    block.material = "rock";
    return block;
}

inline Scene bricks() {
    Scene scene;
    scene.title = "Bricks";
    scene.materials = {{"rock", {2700.0, 50e9, 0.2}}};
    scene.blocks = {brick("slab", 0, 0, 4, 1), brick("left", 0, 1, 2, 1), brick("right", 2, 1, 1, 1)};
    Bolt bolt;
    bolt.name = "B";
    bolt.type = "bar";
    bolt.farEnd = {1.0, 0.5};
    bolt.head = {1.0, 2.0};
    scene.bolts = {bolt};
    BoltType bar;
    bar.name = "bar";
    bar.diameter = 0.02;
    bar.steel = {{0.0, 0.0}, {0.002, 400e6}, {0.1, 500e6}};
    scene.boltTypes = {bar};
    Stage stage;
    stage.name = "lift";
    stage.kind = StageKind::Dynamic;
    scene.stages = {stage};
    return scene;
}

inline BlockState stateOf(const Block& block, const Point& moved, const Stress& stress) {
    BlockState state;
    state.points = block.points;
    for (Point& point : state.points) point += moved;
    state.displacement = moved;
    state.stress = stress;
    state.area = std::abs(signedArea(block.points));
    return state;
}

inline Frame frameOf(const Scene& scene, double lift, double force) {
    Frame frame;
    frame.time = 10.0 * lift;
    frame.blocks = {stateOf(scene.blocks[0], {0, 0}, {0, -1e6, 0}), stateOf(scene.blocks[1], {0, lift}, {0, -3e6, 0}),
                    stateOf(scene.blocks[2], {0, 0}, {2e6, 0, 0})};
    BoltFrame bolt;
    for (int i = 0; i < 4; ++i) {
        BoltNodeFrame node;
        node.s = 0.5 * i;
        node.position = {1.0, 0.5 + 0.5 * i + (i > 1 ? lift : 0.0)};
        node.real = true;
        node.state = NodeState::Bonded;
        node.block = 0;
        node.axialForce = i == 1 ? force : 0.25 * force;
        bolt.nodes.push_back(node);
    }
    frame.bolts = {bolt};
    return frame;
}

/// Frames (or their heads) that show all events until their time.
template <typename Frames>
void countEvents(const std::vector<Event>& events, Frames& frames) {
    for (auto& frame : frames) {
        frame.events = 0;
        for (const Event& event : events)
            frame.events += std::pair(event.stage, event.time) <= std::pair(frame.stage, frame.time) ? 1 : 0;
    }
}

struct BricksRun {
    Scene scene = bricks();
    Results results;
    BricksRun() {
        results.frames = {frameOf(scene, 0.0, 1e3), frameOf(scene, 0.01, 100e3)};
        Event slip;
        slip.kind = EventKind::JointSlip;
        slip.time = 0.02;
        Event yield;
        yield.kind = EventKind::Yield;
        yield.bolt = 0;
        yield.element = 1;
        yield.time = 0.05;
        yield.axialForce = 125e3;
        Event late = yield;
        late.kind = EventKind::TensileRupture;
        late.time = 0.5;
        results.events = {slip, slip, yield, yield, late};
        countEvents(results.events, results.frames);
    }
    SectionPicture picture(std::optional<std::size_t> frame, double factor = 1.0) const {
        const MemoryRun run(scene, results);
        SectionRequest request;
        request.frame = frame;
        request.blocks = findQuantity(blockQuantities(), "sigma1");
        request.bolts = findQuantity(boltQuantities(), "axial_force");
        request.factor = factor;
        return sectionPicture(run, request);
    }
};

}  // namespace keyblock::test
