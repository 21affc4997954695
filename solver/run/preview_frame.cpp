// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/preview_frame.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/setup/make_model.h"
#include "solver/run/observation.h"

#include <cassert>

namespace keyblock {

namespace {

bool isInTunnel(const Scene& scene, const BlockModel& block) {
    return block.rock >= 0 && block.plateOf < 0 && !scene.blocks[block.rock].tunnels.empty();
}

}  // namespace

Frame previewFrame(const Scene& scene) {
    assert(!scene.blocks.empty());
    const Model model = makeModel(scene);
    State state = makeState(model);
    placeBolts(model, state);
    Reference reference;
    Frame frame = Observation(scene, model, state, reference).frame(state, 0, 0.0);
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        if (isInTunnel(scene, model.blocks[b])) frame.blocks[b].area = 0.0;
    for (BoltFrame& bolt : frame.bolts)
        for (BoltNodeFrame& node : bolt.nodes)
            if (node.block >= 0 && isInTunnel(scene, model.blocks[node.block]))
                node.block = -1;
    return frame;
}

}  // namespace keyblock
