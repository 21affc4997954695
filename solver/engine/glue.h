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

/// Links of all glued edges where the cells are: normal, shear, turn for each.
void addGlueLinks(const Model& model, const State& state, StepProblem& problem);

/// The same for a step in motion that moves blocks by about `path` (six rows per block). Directions and lever arms are
/// those after `share` of it; strains at its end are exact, and near it linear.
void addGlueLinksOver(const Model& model, const State& state, const Eigen::VectorXd& path, double share,
                      StepProblem& problem);

/// Displacement of cells over a time in which each block turns evenly about its own centroid; zero for other blocks.
Eigen::VectorXd predictedCellPath(const Model& model, const State& state, double time);

/// True where the glue carries what it would carry where the cells really come to by `d`.
bool glueHolds(const Model& model, const std::vector<BlockMotion>& from, const StepProblem& problem,
               const Eigen::VectorXd& d);

/// Links and energy of the glue.
extern const Carrier glueCarrier;

}  // namespace keyblock
