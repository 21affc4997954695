// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Events that need no release by the program: joints that slip or open, blocks that
// fall, bolts drawn out of a block. Seen by comparing one accepted state with
// the next; each is reported once.
#pragma once

#include "solver/engine/model/state.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace keyblock {

/// What was seen before; joints as pairs of blocks.
struct WatchMemory {
    using Pair = std::pair<int, int>;
    std::map<Pair, Contact> closed;  // when last looked at, with the first contact of the pair as it was
    std::set<Pair> slipped, opened;  // reported in this stage
    std::vector<std::vector<char>> inhabited;  // per bolt and slot: held a node at some time
};

class Watch {
public:
    /// \param memory filled here and kept by the caller, who may put back what it was.
    Watch(const Model& model, const State& start, WatchMemory& memory);

    /// Joint events are reported once per pair of blocks and stage.
    void beginStage(const State& state) const;

    std::vector<Event> look(State& state) const;

    /// Remembers a joint event that was reported, so that it is not reported again.
    void remember(const Event& event) const;

private:
    void lookAtJoints(const State& state, std::vector<Event>& events) const;
    void lookForFalls(State& state, std::vector<Event>& events) const;
    void lookForPulledOut(State& state, std::vector<Event>& events) const;

    const Model& model_;
    std::vector<Point> start_;  // centroids when the run began
    WatchMemory& memory_;
};

}  // namespace keyblock
