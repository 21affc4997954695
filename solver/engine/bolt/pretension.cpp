// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/pretension.h"

namespace keyblock {

void lockOffPlates(const Model& model, State& state) {
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        BoltMotion& motion = state.bolts[b];
        if (!motion.tensioning || !acts(motion)) continue;
        const BoltModel& bolt = model.bolts[b];
        const double force = bolt.pretension, stiffness = bolt.plate.normalStiffness;
        motion.tensioning = false;
        motion.plateOffset = motion.plateStretch + force / stiffness;
        state.energy.external += 0.5 * bolt.share * force * force / stiffness;  // the nut strains the plate
    }
}

}  // namespace keyblock
