// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The design table of a run: for every bolt its peak forces and their utilisation, its
// condition in a frame, the rock that it carries there, and the event since which it has
// carried it.
#pragma once

#include "solver/results/bolt_use.h"
#include "solver/results/run_source.h"
#include "solver/scene/solved_blocks.h"

#include <cstddef>
#include <map>
#include <optional>
#include <ostream>
#include <string_view>
#include <vector>

namespace keyblock {

/// Condition of a bolt; the gravest that applies.
enum class BoltStatus {
    NotInstalled,
    Removed,
    Lost,
    Ruptured,
    PulledOut,
    PlateLost,
    Debonded,
    PartlyDebonded,
    Yielded,
    Intact
};

/// As in tables: not-installed, removed, lost, ruptured, pulled-out, plate-lost, debonded, partly-debonded, yielded,
/// intact.
std::string_view wordOf(BoltStatus status);

/// A block on which a bolt exerts a force against gravity.
struct CarriedBlock {
    int block = -1;  // index in the frames; for a block divided into cells, that of its first cell
    double weight = 0.0;  // weight of the block in the frame, for the thickness of the model [N]
    double force = 0.0;  // net force of the bolt on the block, against the direction of its weight [N]
};

/// Smaller forces, as a fraction of the weight of the block, do not count as carrying it.
inline constexpr double leastCarriedShare = 0.1;

/// Forces of one bolt in a frame: each is the value of largest magnitude along the bolt.
struct BoltForcesNow {
    double axial = 0.0, shear = 0.0;  // [N] of the elements
    double moment = 0.0;  // [N m]
    double plateNormal = 0.0, plateShear = 0.0;  // [N] on the face plate
};

struct BoltDesign {
    BoltUse use;  // peaks from the start of the run to the frame, and utilisation of the strengths
    BoltFrame state;  // in the frame
    BoltStatus status = BoltStatus::NotInstalled;
    std::optional<double> yieldForce;  // axial force at yield when the peak occurred [N]; none: linear steel
    std::optional<double> yieldUse;  // |peak axial force| / `yieldForce`; none: linear steel
    BoltForcesNow now;
    double bondedLength = 0.0;  // tributary length of the real anchors that were bonded at installation [m]
    double debondedLength = 0.0;  // of these, the length that slides, has failed or was pulled out [m]
    std::vector<CarriedBlock> carries;  // largest force first
    /// Index of the event since which the bolt has carried the first of these blocks: the first opening of a joint of
    /// the block after the bolt was installed or, if none opened, the first slip. If other events caused this one, the
    /// event at the start of their chain is given instead. −1: none.
    long since = -1;

    double energy() const { return state.elasticEnergy + state.plasticEnergy + state.bondEnergy; }  // [J]
};

/// Design data of all bolts in the frame with this index; empty for a store without bolt extremes.
/// \pre `frame` is less than `run.frames().size()`.
std::vector<BoltDesign> boltDesigns(const RunSource& run, std::size_t frame);

/// Net forces in a frame [N], for the thickness of the model. Blocks are named by the index of their first cell; a face
/// plate modelled as a block counts as part of the block that it lies against.
struct NetForces {
    std::map<int, Point> weights;  // by block
    std::vector<std::map<int, Point>> bolts;  // per bolt: its force on each block
};

/// All maps are empty if the frame stores no forces.
NetForces netForces(const SolvedBlocks& solved, const Frame& frame);

/// The blocks that each bolt carries, largest force first, without forces below `leastCarriedShare` of the weight of the
/// block. Indexed by bolt.
std::vector<std::vector<CarriedBlock>> carriedBlocks(const NetForces& forces);

/// The columns of the design table, with SI units, after `stage,time_s`.
std::vector<std::string_view> designColumns();

/// Writes a row for each bolt of the frame with this index, or only that of `bolt`, without a header.
void writeDesignRows(const RunSource& run, std::size_t frame, std::optional<int> bolt, std::ostream& out);

}  // namespace keyblock
