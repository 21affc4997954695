// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small scenes that pass many checkpoints, and a sink that keeps these.
#pragma once

#include "solver/files/run_store/checkpoint_bytes.h"
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <string>
#include <vector>

namespace keyblock::test {

/// Keeps every checkpoint as bytes.
class KeepingSink : public MemorySink {
public:
    void checkpoint(const Checkpoint& checkpoint) override { kept.push_back(bytesOf(checkpoint)); }

    std::vector<std::string> kept;
};

/// Brittle bond across a joint, which fails node after node.
inline Scene tearing(int elements = 19) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::PeakResidual, 84.78e6, 24.56e3, 2.24e3)};
    addBolt(scene, type, 0.05, 1.95, elements, PlateKind::None);
    scene.stages = {pullStage(scene, 4e-3, 220)};
    return scene;
}

/// Three boxes on a base that slide, turn and meet.
inline Scene sliding(double duration) {
    Scene scene = emptyScene(1e9, 0.2, 20.0);
    scene.blocks = {boxBlock("base", {-1, -1}, {9, 0}), boxBlock("a", {0, 0}, {1, 1}), boxBlock("b", {0, 1}, {1, 2}),
                    boxBlock("c", {2, 0}, {3, 0.5})};
    Support support;
    support.blockAt = Point(4.0, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {5.0, -8.5};
    scene.stages = {dynamic(duration, 1e-3)};
    scene.output.frames = 20;
    return scene;
}

/// Settles, is pulled, moves freely and settles again.
inline Scene staged() {
    Scene scene = tearing();
    Stage settled;
    settled.name = "settle";
    Stage rest = settled;
    rest.name = "rest";
    rest.zeroDisplacements = true;
    Stage shaken = dynamic(0.3, 1e-3);
    scene.stages = {settled, scene.stages[0], shaken, rest};
    scene.analysis.gravity = {0.0, -9.81};
    return scene;
}

inline KeepingSink runKept(const Scene& scene) {
    KeepingSink sink;
    Control control;
    run(scene, sink, control);
    return sink;
}

}  // namespace keyblock::test
