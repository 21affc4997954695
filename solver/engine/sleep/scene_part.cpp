// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/sleep/scene_part.h"

#include "geometry/grid.h"
#include "solver/engine/contact/candidates.h"
#include "solver/engine/stage/step_build.h"

#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

Box boxOfBolt(const BoltMotion& bolt) {
    std::vector<Point> places;
    for (const BoltNode& node : bolt.nodes) places.push_back(node.x);
    return boxOf(places);
}

/// The entries of `values` at the given indices.
template <typename T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<int>& indices) {
    std::vector<T> some;
    some.reserve(indices.size());
    if (!values.empty())
        for (int i : indices) some.push_back(values[i]);
    return some;
}

template <typename T>
void putBack(const std::vector<T>& some, const std::vector<int>& indices, std::vector<T>& values) {
    for (std::size_t i = 0; i < some.size(); ++i) values[indices[i]] = some[i];
}

/// Indices of the rows for which `belongs` is true.
template <typename T, typename Belongs>
std::vector<int> indicesWhere(const std::vector<T>& rows, Belongs belongs) {
    std::vector<int> indices;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (belongs(rows[i])) indices.push_back(static_cast<int>(i));
    return indices;
}

/// Replaces the blocks of a contact by their indices in another model.
template <typename Renumber>
Contact renumbered(Contact contact, Renumber block) {
    contact.blockA = block(contact.blockA);
    contact.blockB = block(contact.blockB);
    contact.face.other[0] = block(contact.face.other[0]);
    contact.face.other[2] = block(contact.face.other[2]);
    return contact;
}

template <typename Renumber>
void renumberSlots(std::vector<Slot>& slots, Renumber block) {
    for (Slot& slot : slots) slot.block = block(slot.block);
}

/// True for the damping of a bond between cells; other damping is that of a bolt.
bool ofCells(const Link& link, const StepProblem& whole) {
    return link.kind == LinkKind::Drag && link.a < whole.blocks && link.b >= 0 && link.b < whole.blocks;
}

double farthestApart(const Box& a, const Box& b) {
    return std::max((a.min - b.min).cwiseAbs().maxCoeff(), (a.max - b.max).cwiseAbs().maxCoeff());
}

}  // namespace

bool isAwake(const Model& model, const State& state, std::size_t block) {
    return !model.blocks[block].fixed && !state.blocks[block].absent && !state.blocks[block].rest.asleep;
}

std::vector<int> blocksOf(const BoltModel& bolt, const BoltMotion& motion) {
    std::vector<int> blocks;
    for (const Slot& slot : motion.slots) blocks.push_back(slot.block);
    if (bolt.plate.present && bolt.plate.block >= 0) blocks.push_back(bolt.plate.block);
    return blocks;
}

std::vector<char> awakeBolts(const Model& model, const State& state) {
    std::vector<char> awake(model.bolts.size(), 0);
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        if (!acts(state.bolts[b])) continue;
        const std::vector<int> blocks = blocksOf(model.bolts[b], state.bolts[b]);
        const auto any = [&](const auto& isSo) { return std::any_of(blocks.begin(), blocks.end(), isSo); };
        awake[b] = !any([&](int block) { return state.blocks[block].rest.asleep; }) ||
                   any([&](int block) { return isAwake(model, state, block); });
    }
    return awake;
}

ScenePart::ScenePart(const Model& whole, const State& state, const Loads& loads, double reach) : reach_(reach) {
    choose(whole, state);
    makeModel(whole);
    makeLoads(loads);
    for (int block : blocks_) {
        awake_.push_back(isAwake(whole, state, block));
        model_.blocks[awake_.size() - 1].asleep = state.blocks[block].rest.asleep;
        boxes_.push_back(boxOf(state.blocks[block].corners));
    }
    for (int bolt : bolts_) boxes_.push_back(boxOfBolt(state.bolts[bolt]));
}

/// Adds the bolts that a block which is awake may reach.
void ScenePart::addReached(const Model& whole, const State& state, std::vector<char>& bolts) const {
    for (std::size_t b = 0; b < bolts.size(); ++b) {
        if (bolts[b] || !acts(state.bolts[b])) continue;
        const Box box = grown(boxOfBolt(state.bolts[b]), reach_);
        for (std::size_t i = 0; i < whole.blocks.size() && !bolts[b]; ++i)
            bolts[b] = isAwake(whole, state, i) && meets(box, boxOf(state.blocks[i].corners));
    }
}

/// Chooses the blocks and bolts of the part; of a block that is divided into cells, all cells.
void ScenePart::choose(const Model& whole, const State& state) {
    std::vector<char> bolts = awakeBolts(whole, state);
    addReached(whole, state, bolts);
    std::vector<char> chosen(whole.blocks.size(), 0);
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = isAwake(whole, state, i);
    partBolt_.assign(bolts.size(), -1);
    for (std::size_t b = 0; b < bolts.size(); ++b) {
        if (!bolts[b]) continue;
        partBolt_[b] = static_cast<int>(bolts_.size());
        bolts_.push_back(static_cast<int>(b));
        for (int block : blocksOf(whole.bolts[b], state.bolts[b])) chosen[block] = 1;
    }
    addNear(whole, state, chosen);
    partBlock_.assign(chosen.size(), -1);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const int first = wholeOf(whole, static_cast<int>(i)), end = endOfWhole(whole, first);
        if (std::none_of(chosen.begin() + first, chosen.begin() + end, [](char c) { return c; })) continue;
        partBlock_[i] = static_cast<int>(blocks_.size());
        blocks_.push_back(static_cast<int>(i));
    }
}

/// Adds the blocks that those already chosen may reach.
void ScenePart::addNear(const Model& whole, const State& state, std::vector<char>& chosen) const {
    std::vector<int> present;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (state.blocks[i].absent) continue;
        present.push_back(static_cast<int>(i));
        boxes.push_back(boxOf(state.blocks[i].corners));
    }
    const BoxGrid grid(boxes);
    const auto add = [&](const Box& box) {
        for (int at : grid.meeting(grown(box, reach_))) chosen[present[at]] = 1;
    };
    for (std::size_t at = 0; at < present.size(); ++at)
        if (isAwake(whole, state, present[at])) add(boxes[at]);
    for (int bolt : bolts_) add(boxOfBolt(state.bolts[bolt]));
}

void ScenePart::makeModel(const Model& whole) {
    const auto part = [&](int block) { return partOf(block); };
    model_.origin = whole.origin;
    model_.size = whole.size;
    model_.tolerance = whole.tolerance;
    model_.thickness = whole.thickness;
    model_.gravity = whole.gravity;
    model_.stiffest = whole.stiffest;
    model_.smallest = whole.smallest;
    model_.joints = whole.joints;
    model_.openings = whole.openings;
    model_.hasSides = whole.hasSides;
    model_.analysis = whole.analysis;
    model_.numerics = whole.numerics;
    model_.blocks = picked(whole.blocks, blocks_);
    const int rocks = static_cast<int>(whole.firstOf.size()) - 1;
    std::vector<int> partRock(rocks, -1);
    for (int rock = 0; rock < rocks; ++rock) {
        if (whole.firstOf[rock] == whole.firstOf[rock + 1] || partBlock_[whole.firstOf[rock]] < 0) continue;
        const int first = partBlock_[whole.firstOf[rock]], cells = whole.firstOf[rock + 1] - whole.firstOf[rock];
        partRock[rock] = static_cast<int>(model_.firstOf.size());
        for (int cell = first; cell < first + cells; ++cell) model_.blocks[cell].rock = partRock[rock];
        model_.firstOf.push_back(first);
    }
    const auto plates = std::lower_bound(blocks_.begin(), blocks_.end(), whole.firstOf.back());
    model_.firstOf.push_back(static_cast<int>(plates - blocks_.begin()));
    for (BlockModel& block : model_.blocks) {
        if (block.plateOf < 0) continue;
        if (block.rock >= 0) block.rock = partRock[block.rock];
        block.plateOf = std::max(0, partBolt_[block.plateOf]);  // it remains a plate if its bolt sleeps
    }
    glue_ = indicesWhere(whole.glue, [&](const GlueModel& glue) { return partOf(glue.a) >= 0; });
    model_.glue = picked(whole.glue, glue_);
    for (GlueModel& glue : model_.glue) glue.a = part(glue.a), glue.b = part(glue.b);
    supports_ = indicesWhere(whole.supports, [&](const PointSupport& support) { return partOf(support.block) >= 0; });
    model_.supports = picked(whole.supports, supports_);
    for (PointSupport& support : model_.supports) support.block = part(support.block);
    for (int block : blocks_)
        for (int k = 0; k < 6; ++k) unknowns_.push_back(6 * block + k);
    model_.bolts = picked(whole.bolts, bolts_);
    for (BoltModel& bolt : model_.bolts) {
        const int first = 6 * static_cast<int>(whole.blocks.size()) + 3 * bolt.firstNode;
        for (int k = 0; k < 3 * static_cast<int>(bolt.s.size()); ++k) unknowns_.push_back(first + k);
        renumberSlots(bolt.slots, part);
        for (int& block : bolt.startBlock) block = part(block);
        bolt.plate.block = part(bolt.plate.block);
        bolt.firstNode = model_.nodes;
        model_.nodes += static_cast<int>(bolt.s.size());
    }
}

void ScenePart::makeLoads(const Loads& whole) {
    const auto take = [&](const auto& rows, auto& own, std::vector<int>& indices) {
        indices = indicesWhere(rows, [&](const auto& row) { return row.block >= 0 && partOf(row.block) >= 0; });
        own = picked(rows, indices);
        for (auto& row : own) row.block = partOf(row.block);
    };
    std::vector<int> dashpots;
    take(whole.forces, loads_.forces, forces_);
    take(whole.pressures, loads_.pressures, pressures_);
    take(whole.motions, loads_.motions, motions_);
    take(whole.dashpots, loads_.dashpots, dashpots);
    walls_ = indicesWhere(whole.walls, [&](const WallForce& wall) {
        return wall.block >= 0 ? partOf(wall.block) >= 0 : partBolt_[wall.bolt] >= 0;
    });
    loads_.walls = picked(whole.walls, walls_);
    for (WallForce& wall : loads_.walls) {
        wall.block = partOf(wall.block);
        if (wall.bolt >= 0) wall.bolt = partBolt_[wall.bolt];
    }
}

bool ScenePart::holds(const State& whole, double ahead) const {
    for (std::size_t i = 0; i < blocks_.size(); ++i)
        if (awake_[i] && farthestApart(boxOf(whole.blocks[blocks_[i]].corners), boxes_[i]) + ahead > reach_)
            return false;
    for (std::size_t b = 0; b < bolts_.size(); ++b) {
        const BoltMotion& bolt = whole.bolts[bolts_[b]];
        if (!acts(bolt) || farthestApart(boxOfBolt(bolt), boxes_[blocks_.size() + b]) + ahead > reach_) return false;
    }
    return true;
}

LoadPoint ScenePart::loadsAt(const LoadPoint& whole) const {
    LoadPoint at = whole;
    at.forces = picked(whole.forces, forces_);
    at.pressures = picked(whole.pressures, pressures_);
    at.motions = picked(whole.motions, motions_);
    at.walls = picked(whole.walls, walls_);
    return at;
}

State ScenePart::stateOf(const State& whole) const {
    const auto part = [&](int block) { return partOf(block); };
    State state;
    state.blocks = picked(whole.blocks, blocks_);
    for (const Contact& c : whole.contacts)
        if (isOfPart(c)) state.contacts.push_back(renumbered(c, part));
    state.supports = picked(whole.supports, supports_);
    state.glue = picked(whole.glue, glue_);
    state.bolts = picked(whole.bolts, bolts_);
    for (BoltMotion& bolt : state.bolts) renumberSlots(bolt.slots, part);
    state.openings = whole.openings;
    state.acceleration = picked(whole.acceleration, unknowns_);
    state.energy = whole.energy;
    state.startEnergy = whole.startEnergy;
    state.step = whole.step;
    return state;
}

/// Replaces the contacts of the part in the sorted list of the whole. In most steps they are the same pairs of corner
/// and edge.
void ScenePart::putContacts(std::vector<Contact> own, std::vector<Contact>& contacts) const {
    const auto same = [](const Contact& x, const Contact& y) { return !comesBefore(x, y) && !comesBefore(y, x); };
    auto next = own.begin();
    const auto other = std::find_if(contacts.begin(), contacts.end(), [&](const Contact& c) {
        if (!isOfPart(c)) return false;
        return next == own.end() || !same(*next++, c);
    });
    if (other == contacts.end() && next == own.end()) {
        next = own.begin();
        for (Contact& c : contacts)
            if (isOfPart(c)) c = *next++;
        return;
    }
    std::erase_if(contacts, [&](const Contact& c) { return isOfPart(c); });
    std::vector<Contact> all;
    all.reserve(contacts.size() + own.size());
    std::merge(contacts.begin(), contacts.end(), own.begin(), own.end(), std::back_inserter(all), comesBefore);
    contacts = std::move(all);
}

void ScenePart::writeBack(const State& part, State& whole) const {
    const auto inWhole = [&](int block) { return wholeBlock(block); };
    for (std::size_t i = 0; i < blocks_.size(); ++i)
        if (awake_[i]) whole.blocks[blocks_[i]] = part.blocks[i];
    std::vector<Contact> own;
    own.reserve(part.contacts.size());
    for (const Contact& c : part.contacts) own.push_back(renumbered(c, inWhole));
    putContacts(std::move(own), whole.contacts);
    putBack(part.supports, supports_, whole.supports);
    putBack(part.glue, glue_, whole.glue);
    for (std::size_t b = 0; b < bolts_.size(); ++b) {
        whole.bolts[bolts_[b]] = part.bolts[b];
        renumberSlots(whole.bolts[bolts_[b]].slots, inWhole);
    }
    whole.openings = part.openings;
    for (std::size_t i = 0; i < part.acceleration.size(); ++i)
        if (i >= 6 * blocks_.size() || awake_[i / 6]) whole.acceleration[unknowns_[i]] = part.acceleration[i];
    whole.energy = part.energy;
    whole.startEnergy = part.startEnergy;
    whole.step = part.step;
}

/// Index in the whole scene of a body of a step of the part.
int ScenePart::wholeBody(const StepProblem& problem, int body, int wholeBlocks) const {
    if (body < problem.blocks) return wholeBlock(body);
    return wholeBlocks + (unknowns_[problem.first(body)] - 6 * wholeBlocks) / 3;
}

/// The links of the part, then those of the rest of the scene.
std::vector<Link> ScenePart::joinLinks(const StepProblem& part, const StepProblem& whole, const State& now) const {
    const std::vector<int> contacts = indicesWhere(now.contacts, [&](const Contact& c) { return isOfPart(c); });
    std::vector<char> inPart(whole.blocks + whole.nodes, 0);
    for (int body = 0; body < part.blocks + part.nodes; ++body) inPart[wholeBody(part, body, whole.blocks)] = 1;
    std::vector<Link> links = part.links;
    for (Link& link : links) {
        link.a = wholeBody(part, link.a, whole.blocks);
        if (link.b >= 0) link.b = wholeBody(part, link.b, whole.blocks);
        if (ofContact(link.kind)) link.owner = contacts[link.owner];
        else if (link.kind == LinkKind::Glue || ofCells(link, whole)) link.owner = glue_[link.owner];
        else if (link.kind == LinkKind::Support) link.owner = supports_[link.owner];
        else link.owner = wholeBolt(link.owner);
    }
    for (const Link& link : whole.links)
        if (!inPart[link.a] || (link.b >= 0 && !inPart[link.b])) links.push_back(link);
    return links;
}

TakenStep ScenePart::inWhole(const Model& whole, const Loads& loads, const LoadPoint& at, const TakenStep& step,
                             const State& now) const {
    const auto spread = [&](const Eigen::VectorXd& own, Eigen::VectorXd& all) {
        for (Eigen::Index i = 0; i < own.size(); ++i) all[unknowns_[i]] = own[i];
    };
    TakenStep all;
    all.before = now;
    writeBack(step.before, all.before);
    all.at = at;
    all.options = step.options;
    all.problem = buildStep(whole, now, loads, at, step.options);
    all.problem.links = joinLinks(step.problem, all.problem, now);
    all.problem.limitPairs.clear();
    spread(step.problem.load, all.problem.load);
    all.d = Eigen::VectorXd::Zero(all.problem.unknowns());
    spread(step.d, all.d);
    if (step.path.size() > 0) {
        all.path = Eigen::VectorXd::Zero(all.d.size());
        spread(step.path, all.path);
    }
    all.step = step.step;
    return all;
}

}  // namespace keyblock
