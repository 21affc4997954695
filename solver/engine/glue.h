// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic bond ("glue") between the cells of a block. Each shared edge has three links
// that never fail. Two stiff ones at its midpoint keep the cells together. The third
// resists relative rotation, with a stiffness that represents the bending of the two
// cells, whose strain is constant (theory, "Sub-blocks").
#pragma once

#include "geometry/cells/sub_blocks.h"
#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Stiffness of the springs at an edge's midpoint, as a multiple of the stiffness of the rock between the cells'
/// centroids.
inline constexpr double glueMultiple = 1000.0;

/// Glue along one edge.
/// \param edge the shared edge; its cells are indices into Model::blocks, which must already contain them.
GlueModel glueModel(const Scene& scene, const Model& model, const SharedEdge& edge);

/// Adds the links of all glued edges at the current positions of the cells: normal, shear and rotation for each edge.
void addGlueLinks(const Model& model, const State& state, StepProblem& problem);

/// Adds the links of all glued edges for a dynamic step with an expected displacement `path` (six values per block).
/// Directions and lever arms are evaluated after a fraction `share` of the path. Strains are exact for the displacement
/// `path` and vary linearly with any deviation from it.
void addGlueLinksOver(const Model& model, const State& state, const Eigen::VectorXd& path, double share,
                      StepProblem& problem);

/// Displacement of the cells over `time` [s] predicted from the current velocities: each block that is divided into
/// cells moves with its mean velocity and rotates uniformly about its own centroid. Six values per block; zero for
/// undivided blocks.
Eigen::VectorXd predictedCellPath(const Model& model, const State& state, double time);

/// True if the linearised glue forces agree, within a tolerance, with the glue forces at the exact positions of the
/// cells after displacement `d`.
/// \param from the positions at the start of the step.
bool glueHolds(const Model& model, const std::vector<BlockMotion>& from, const StepProblem& problem,
               const Eigen::VectorXd& d);

/// Force carrier of the glue.
extern const Carrier glueCarrier;

}  // namespace keyblock
