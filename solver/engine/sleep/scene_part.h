// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a scene that a step models while other blocks sleep: the blocks that are
// awake, the bolts that cross them or that they may reach, and around them the sleeping
// and fixed blocks that they may reach, which hold their place. It is a model of its own, so that search,
// step and acceptance cost what is awake and not what exists.
#pragma once

#include "geometry/polygon.h"
#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/engine/stage/taken_step.h"

#include <vector>

namespace keyblock {

/// True if a block moves with the steps: it is neither fixed, absent nor asleep.
bool isAwake(const Model& model, const State& state, std::size_t block);

/// The blocks that a bolt crosses or is held by.
std::vector<int> blocksOf(const BoltModel& bolt, const BoltMotion& motion);

/// Per bolt: true if it acts, unless all blocks that it crosses or is held by are asleep or fixed and at least one of
/// them sleeps: then it rests with them.
std::vector<char> awakeBolts(const Model& model, const State& state);

class ScenePart {
public:
    /// \param reach distance [m] that a block or bolt that is awake may move until the part is made again.
    ScenePart(const Model& whole, const State& state, const Loads& loads, double reach);

    const Model& model() const { return model_; }
    const Loads& loads() const { return loads_; }

    /// True while every block and bolt that is awake is less than the reach, minus `ahead`, from where it was when the
    /// part was made, and the same bolts act.
    /// \param ahead the range of the contact search of the coming step [m].
    bool holds(const State& whole, double ahead) const;

    /// The rows of `whole` that belong to the part.
    LoadPoint loadsAt(const LoadPoint& whole) const;
    State stateOf(const State& whole) const;

    /// Writes what steps have changed in the part back into the whole.
    void writeBack(const State& part, State& whole) const;

    /// Indices in the whole scene of a block or bolt of the part; −1 stays −1.
    int wholeBlock(int block) const { return block < 0 ? -1 : blocks_[block]; }
    int wholeBolt(int bolt) const { return bolt < 0 ? -1 : bolts_[bolt]; }

    /// The last step of the part as a step of the whole scene, in which sleeping blocks do not move.
    /// \param loads, at the loads of the whole scene in this step. \param now its state after the step.
    TakenStep inWhole(const Model& whole, const Loads& loads, const LoadPoint& at, const TakenStep& step,
                      const State& now) const;

private:
    void choose(const Model& whole, const State& state);
    void addReached(const Model& whole, const State& state, std::vector<char>& bolts) const;
    void addNear(const Model& whole, const State& state, std::vector<char>& chosen) const;
    void makeModel(const Model& whole);
    void makeLoads(const Loads& whole);
    int partOf(int block) const { return block < 0 ? -1 : partBlock_[block]; }
    bool isOfPart(const Contact& c) const { return partBlock_[c.blockA] >= 0 && partBlock_[c.blockB] >= 0; }
    void putContacts(std::vector<Contact> own, std::vector<Contact>& contacts) const;
    int wholeBody(const StepProblem& problem, int body, int wholeBlocks) const;
    std::vector<Link> joinLinks(const StepProblem& part, const StepProblem& whole, const State& now) const;

    double reach_;
    Model model_;
    Loads loads_;
    std::vector<int> blocks_, bolts_, glue_, supports_;  // indices in the whole scene, ascending
    std::vector<int> unknowns_;  // per unknown of the part: its index in the whole scene
    std::vector<int> forces_, pressures_, motions_, walls_;  // of the loads, likewise
    std::vector<int> partBlock_, partBolt_;  // per block and bolt of the whole scene: index in the part, or −1
    std::vector<char> awake_;  // per block of the part
    std::vector<Box> boxes_;  // per block of the part, then per bolt, when the part was made
};

}  // namespace keyblock
