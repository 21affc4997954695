// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Events that are not releases made by the solver: joints that slip or open, blocks
// that fall, bolts pulled out of a block. They are detected by comparing each accepted
// state with the next; each is reported once.
#pragma once

#include "solver/engine/model/state.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace keyblock {

/// Earlier observations. A joint is identified by the indices of its two blocks. Part of the checkpoint.
struct WatchMemory {
    using Pair = std::pair<int, int>;
    std::map<Pair, Contact> closed;  // joints closed at the latest check, with the first contact of each at that time
    std::set<Pair> slipped, opened;  // joints whose slip or opening was reported in this stage
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
    void lookForFalls(State& state, std::vector<Event>& events) const;
    void lookForPulledOut(State& state, std::vector<Event>& events) const;

    const Model& model_;
    std::vector<Point> start_;  // centroids at the start of the run
    WatchMemory& memory_;
};

}  // namespace keyblock
