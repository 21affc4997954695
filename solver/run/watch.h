// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Events that nobody has to release: joints that slip or open, blocks that
// fall, bolts drawn out of a block. Seen by comparing one accepted state with
// the next; each is told once.
#pragma once

#include "solver/engine/state.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace keyblock {

class Watch {
public:
    Watch(const Model& model, const State& start);

    /// Joint events are told once per pair of blocks and stage.
    void beginStage(const State& state);

    std::vector<Event> look(State& state);

    /// A joint event that another has told of.
    void told(const Event& event);

private:
    using Pair = std::pair<int, int>;
    void lookAtJoints(const State& state, std::vector<Event>& events);
    void lookForFalls(State& state, std::vector<Event>& events) const;
    void lookForPulledOut(State& state, std::vector<Event>& events);

    const Model& model_;
    std::vector<Point> start_;  // centroids when the run began
    std::map<Pair, Contact> closed_;  // with the first contact of the pair as it was last
    std::set<Pair> slipped_, opened_;
    std::vector<std::vector<char>> inhabited_;  // per bolt and slot: held a node at the start
};

}  // namespace keyblock
