// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What joins the cells of one block. Three elastic links an edge, which never
// fail: stiff ones at its middle keep the cells together, and one against turning
// has just the stiffness with which the cells, whose strain is constant, would
// bend (theory, "Sub-blocks").
#pragma once

#include "geometry/sub_blocks.h"
#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Springs at an edge's middle over the stiffness of the rock between the cells' centroids.
inline constexpr double glueMultiple = 1000.0;

/// Bond along one edge. \param edge by rows of the model's blocks, which exist already.
GlueModel glueModel(const Scene& scene, const Model& model, const SharedEdge& edge);

/// Links of all glued edges: normal, shear, turn for each. \param lead time from the state to the position at which
/// directions and lever arms are taken [s]: half of a dynamic step keeps the angular momentum, 0 in a static one.
void addGlueLinks(const Model& model, const State& state, double lead, StepProblem& problem);

/// Links and energy of the glue.
extern const Carrier glueCarrier;

}  // namespace keyblock
