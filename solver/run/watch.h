// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Events that are not releases made by the solver: joints that slip or open, blocks
// that fall, bolts pulled out of a block. They are detected by comparing each accepted
// state with the next; each is reported once.
#pragma once

#include "solver/engine/model/state.h"

#include <boost/container/flat_set.hpp>

#include <utility>
#include <vector>

namespace keyblock {

/// A closed joint and its first contact.
struct ClosedJoint {
    std::pair<int, int> blocks{-1, -1};  // smaller index first
    std::pair<int, int> bodies{-1, -1};  // the blocks or cells that touch, smaller index first
    Point position{0.0, 0.0};  // of the contact [m]
    double normalForce = 0.0, shearForce = 0.0;  // of the contact, compression positive [N]
    double slip = 0.0;  // of the contact [m]
};

/// Earlier observations. A joint is identified by the indices of its two blocks. Part of the checkpoint.
struct WatchMemory {
    using Pair = std::pair<int, int>;
    std::vector<ClosedJoint> closed;  // joints closed at the latest check, sorted by `blocks`, one for each two blocks
    boost::container::flat_set<Pair> slipped, opened;  // joints whose slip or opening was reported in this stage
    std::vector<std::vector<char>> inhabited;  // per bolt and borehole slot: whether it has ever contained a node
};

class Watch {
public:
    /// \param memory owned by the caller and filled in by the constructor; to resume a run, the caller overwrites it.
    Watch(const Model& model, const State& start, WatchMemory& memory);

    /// Prepares for a new stage: joint events are reported once per pair of blocks and stage.
    void beginStage(const State& state) const;

    /// Returns the events since the last check, and marks fallen blocks and pulled-out bolts in `state`.
    std::vector<Event> look(State& state) const;

    /// Records a joint event reported elsewhere, so that it is not reported again.
    void remember(const Event& event) const;

private:
    void lookAtJoints(const State& state, std::vector<Event>& events) const;
    void lookForOpenings(const State& state, const std::vector<ClosedJoint>& now, std::vector<Event>& events) const;
    void reportOpening(const State& state, const ClosedJoint& before, std::vector<Event>& events) const;
    bool rest(const State& state, const WatchMemory::Pair& blocks) const;
    void lookForFalls(State& state, std::vector<Event>& events) const;
    void lookForPulledOut(State& state, std::vector<Event>& events) const;

    const Model& model_;
    std::vector<Point> start_;  // centroids at the start of the run
    WatchMemory& memory_;
};

}  // namespace keyblock
