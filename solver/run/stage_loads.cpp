// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/stage_loads.h"

#include "geometry/polygon.h"
#include "solver/engine/contacts.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

const Table always{{0.0, 1.0}};

/// Straight lines between the entries, held before the first and after the last.
double valueAt(const Table& table, double time) {
    if (time <= table.front().first) return table.front().second;
    for (std::size_t i = 1; i < table.size(); ++i) {
        const auto& [t0, v0] = table[i - 1];
        const auto& [t1, v1] = table[i];
        if (time <= t1) return time == t1 ? v1 : v0 + (time - t0) / (t1 - t0) * (v1 - v0);
    }
    return table.back().second;
}

const Table* tableOf(const Table& table) { return table.empty() ? &always : &table; }

bool changes(const Table& table) {
    return std::any_of(table.begin(), table.end(), [&](const auto& entry) {
        return entry.first > 0.0 && entry.second != valueAt(table, 0.0);
    });
}

}  // namespace

int StageLoads::blockHolding(const State& state, const Point& place) const {
    const Point p = place - model_.origin;
    const auto rocks = static_cast<std::size_t>(model_.firstOf.back());  // places are in rock, never in a plate
    for (std::size_t i = 0; i < rocks; ++i)
        if (locate(state.blocks[i].corners, p, model_.tolerance) == Side::Inside) return static_cast<int>(i);
    for (std::size_t i = 0; i < rocks; ++i)
        if (locate(state.blocks[i].corners, p, model_.tolerance) == Side::Boundary) return static_cast<int>(i);
    // the block has moved away from where the scene shows it: the place as it was at the start
    for (std::size_t i = 0; i < rocks; ++i)
        if (locate(startCorners(model_.blocks[i]), p, model_.tolerance) != Side::Outside) return static_cast<int>(i);
    return -1;
}

void StageLoads::addPressure(const Load& load, const State& state) {
    const Point a = (*load.along)[0] - model_.origin, b = (*load.along)[1] - model_.origin;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model_.firstOf.back()); ++i)
        for (int e = 0; e < static_cast<int>(state.blocks[i].corners.size()); ++e) {
            if (!model_.blocks[i].inner.empty() && model_.blocks[i].inner[static_cast<std::size_t>(e)]) continue;
            const Edge edge = edgeOf(state.blocks[i].corners, e);
            const double near = 10.0 * model_.tolerance;
            if (std::abs(edge.outward.dot(a - edge.start)) > near || std::abs(edge.outward.dot(b - edge.start)) > near)
                continue;
            double from = edge.along.dot(a - edge.start), to = edge.along.dot(b - edge.start);
            if (from > to) std::swap(from, to);
            from = std::max(from, 0.0);
            to = std::min(to, edge.length);
            if (to - from <= near) continue;
            loads_.pressures.push_back({static_cast<int>(i), e, from / edge.length, to / edge.length, load.pressure});
            pressureTables_.push_back(tableOf(load.table));
            start_.pressures.push_back(0.0);
        }
}

void StageLoads::addLoad(const Load& load, const State& state) {
    if (load.along) {
        addPressure(load, state);
        return;
    }
    const Point named = load.blockAt ? *load.blockAt : *load.point;
    const int block = blockHolding(state, named);
    if (load.blockAt && !load.at) {
        addSpread(load, block);
        return;
    }
    const Point at = load.point ? *load.point : *load.at;
    const int holding = load.at && model_.blocks[static_cast<std::size_t>(block)].cell ? blockHolding(state, at) : block;
    const BlockMotion& motion = state.blocks[static_cast<std::size_t>(holding)];
    addForce({holding, materialPlace(motion, at - model_.origin), load.force}, load);
}

/// At the block's centroid: at those of its cells by their mass.
void StageLoads::addSpread(const Load& load, int block) {
    const BlockModel& named = model_.blocks[static_cast<std::size_t>(block)];
    if (!named.cell) {
        addForce({block, {0.0, 0.0}, load.force}, load);
        return;
    }
    const auto rock = static_cast<std::size_t>(named.rock);
    double mass = 0.0;
    for (int cell = model_.firstOf[rock]; cell < model_.firstOf[rock + 1]; ++cell) mass += model_.blocks[cell].mass;
    for (int cell = model_.firstOf[rock]; cell < model_.firstOf[rock + 1]; ++cell)
        addForce({cell, {0.0, 0.0}, model_.blocks[cell].mass / mass * load.force}, load);
}

void StageLoads::addForce(const PointForce& force, const Load& load) {
    loads_.forces.push_back(force);
    forceTables_.push_back(tableOf(load.table));
    start_.forces.push_back(0.0);
}

void StageLoads::addMotion(const Motion& motion, State& state) {
    const int block = blockHolding(state, motion.blockAt);
    for (std::size_t i = 0; i < loads_.motions.size(); ++i) {
        if (loads_.motions[i].block != block) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        loads_.motions.erase(loads_.motions.begin() + at);
        motionTables_.erase(motionTables_.begin() + at);
        start_.motions.erase(start_.motions.begin() + at);
        break;
    }
    const PrescribedMotion prescribed{block, motion.axis.normalized(), motion.rotation == Rotation::Held};
    turnUnknowns(state.blocks[static_cast<std::size_t>(block)], prescribed.axis);
    loads_.motions.push_back(prescribed);
    motionTables_.push_back(tableOf(motion.table));
    start_.motions.push_back(displacementAlong(model_, state, prescribed));
}

void StageLoads::begin(const Stage& stage, State& state) {
    forceTables_.assign(loads_.forces.size(), nullptr);
    pressureTables_.assign(loads_.pressures.size(), nullptr);
    motionTables_.assign(loads_.motions.size(), nullptr);
    for (const Load& load : stage.loads) addLoad(load, state);
    for (const Motion& motion : stage.motions) addMotion(motion, state);
    start_.time = 0.0;
}

LoadPoint StageLoads::at(double time) const {
    LoadPoint point = start_;
    point.time = time;
    point.gravity = 1.0;
    const auto fill = [&](std::vector<double>& values, const std::vector<const Table*>& tables) {
        for (std::size_t i = 0; i < tables.size(); ++i)
            if (tables[i]) values[i] = valueAt(*tables[i], time);
    };
    fill(point.forces, forceTables_);
    fill(point.pressures, pressureTables_);
    fill(point.motions, motionTables_);
    return point;
}

std::vector<double> StageLoads::turns() const {
    std::vector<double> times;
    for (const auto* tables : {&forceTables_, &pressureTables_, &motionTables_})
        for (const Table* table : *tables)
            for (const auto& [time, value] : table ? *table : always)
                if (time > 0.0 && time < 1.0) times.push_back(time);
    return times;
}

bool StageLoads::varies() const {
    for (const auto* tables : {&forceTables_, &pressureTables_, &motionTables_})
        for (const Table* table : *tables)
            if (table && changes(*table)) return true;
    return false;
}

}  // namespace keyblock
