// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/stage_loads.h"

#include "geometry/polygon.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/stage/step_build.h"
#include "solver/scene/acceleration.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {
namespace {

const Table always{{0.0, 1.0}};

/// Linear interpolation between the entries; constant before the first and after the last.
double valueAt(const Table& table, double time) {
    if (time <= table.front().first) return table.front().second;
    for (std::size_t i = 1; i < table.size(); ++i) {
        const auto& [t0, v0] = table[i - 1];
        const auto& [t1, v1] = table[i];
        if (time <= t1) return time == t1 ? v1 : v0 + (time - t0) / (t1 - t0) * (v1 - v0);
    }
    return table.back().second;
}

const Table& tableOf(const Table& table) { return table.empty() ? always : table; }

bool changes(const Table& table) {
    return std::any_of(table.begin(), table.end(), [&](const auto& entry) {
        return entry.first > 0.0 && entry.second != valueAt(table, 0.0);
    });
}

/// Compares positions as given in the scene, which do not change when the rock moves.
bool samePlace(const Load& before, const Load& now, bool sameBlock) {
    if (now.along) return before.along == now.along;
    if (now.point) return before.point == now.point;
    return before.blockAt && sameBlock && before.at == now.at;
}

/// Removes rows from several lists at once.
template <class Rows, class... Others>
void dropRows(const std::vector<char>& drop, Rows& rows, Others&... others) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (drop[i]) continue;
        if (kept != i) rows[kept] = rows[i];
        ++kept;
    }
    rows.resize(kept);
    if constexpr (sizeof...(others) > 0) dropRows(drop, others...);
}

}  // namespace

int StageLoads::blockHolding(const State& state, const Point& place) const {
    const Point p = place - model_.origin;
    const std::size_t rocks = model_.firstOf.back();  // points are in rock, never in a face plate
    const auto stands = [&](std::size_t block) { return !state.blocks[block].absent; };
    for (std::size_t i = 0; i < rocks; ++i)
        if (stands(i) && locate(state.blocks[i].corners, p, model_.tolerance) == Side::Inside) return static_cast<int>(i);
    for (std::size_t i = 0; i < rocks; ++i)
        if (stands(i) && locate(state.blocks[i].corners, p, model_.tolerance) == Side::Boundary) return static_cast<int>(i);
    // the block has moved away from its position in the scene: use its position at the start
    for (std::size_t i = 0; i < rocks; ++i)
        if (stands(i) && locate(startCorners(model_.blocks[i]), p, model_.tolerance) != Side::Outside) return static_cast<int>(i);
    return -1;
}

const Load& StageLoads::loadOf(const LoadSource& source) const {
    return scene_.stages[source.stage].loads[source.row];
}

/// The line is given in the geometry of the scene, so edges are searched at their original positions, wherever they are
/// now.
void StageLoads::addPressure(int row, const State& state) {
    const Load& load = stage().loads[row];
    const Point a = (*load.along)[0] - model_.origin, b = (*load.along)[1] - model_.origin;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model_.firstOf.back()); ++i) {
        if (state.blocks[i].absent) continue;
        const std::vector<Point> corners = startCorners(model_.blocks[i]);
        for (int e = 0; e < static_cast<int>(corners.size()); ++e) {
            if (!model_.blocks[i].inner.empty() && model_.blocks[i].inner[e]) continue;
            const Edge edge = edgeOf(corners, e);
            const double near = 10.0 * model_.tolerance;
            if (std::abs(edge.outward.dot(a - edge.start)) > near || std::abs(edge.outward.dot(b - edge.start)) > near)
                continue;
            double from = edge.along.dot(a - edge.start), to = edge.along.dot(b - edge.start);
            if (from > to) std::swap(from, to);
            from = std::max(from, 0.0);
            to = std::min(to, edge.length);
            if (to - from <= near) continue;
            const double first = from / edge.length, last = to / edge.length;
            memory_.loads.pressures.push_back({static_cast<int>(i), e, first, last, load.pressure});
            memory_.pressureSources.push_back({memory_.stage, row});
            memory_.start.pressures.push_back(0.0);
        }
    }
}

void StageLoads::addLoad(int row, const State& state) {
    const Load& load = stage().loads[row];
    if (load.along) {
        replace(load, -1);
        addPressure(row, state);
        return;
    }
    const Point named = load.blockAt ? *load.blockAt : *load.point;
    const int block = blockHolding(state, named);
    replace(load, block);
    if (load.blockAt && !load.at) {
        addSpread(row, block);
        return;
    }
    const Point at = load.point ? *load.point : *load.at;
    const int holding = load.at && model_.blocks[block].cell ? blockHolding(state, at) : block;
    const BlockMotion& motion = state.blocks[holding];
    addForce({holding, materialPlace(motion, at - model_.origin), load.force}, row);
}

/// Applies the load at the block's centroid, or at the centroids of its cells in proportion to their mass.
void StageLoads::addSpread(int row, int block) {
    const Point& force = stage().loads[row].force;
    const BlockModel& named = model_.blocks[block];
    if (!named.cell) {
        addForce({block, {0.0, 0.0}, force}, row);
        return;
    }
    const std::size_t rock = named.rock;
    double mass = 0.0;
    for (int cell = model_.firstOf[rock]; cell < model_.firstOf[rock + 1]; ++cell) mass += model_.blocks[cell].mass;
    for (int cell = model_.firstOf[rock]; cell < model_.firstOf[rock + 1]; ++cell)
        addForce({cell, {0.0, 0.0}, model_.blocks[cell].mass / mass * force}, row);
}

void StageLoads::addForce(const PointForce& force, int row) {
    memory_.loads.forces.push_back(force);
    memory_.forceSources.push_back({memory_.stage, row});
    memory_.start.forces.push_back(0.0);
}

/// A replaced load stays in the list: it fades out in the first increment of the stage while the new one is applied.
void StageLoads::replace(const Load& load, int block) {
    for (std::size_t i = 0; i < memory_.forceSources.size(); ++i) {
        LoadSource& source = memory_.forceSources[i];
        const bool sameBlock = block >= 0 && sameRock(model_, memory_.loads.forces[i].block, block);
        if (source.stage < memory_.stage && samePlace(loadOf(source), load, sameBlock)) source.replaced = true;
    }
    for (LoadSource& source : memory_.pressureSources)
        if (source.stage < memory_.stage && samePlace(loadOf(source), load, false)) source.replaced = true;
}

void StageLoads::addMotion(int row, State& state) {
    const Motion& motion = stage().motions[row];
    const int block = blockHolding(state, motion.blockAt);
    for (std::size_t i = 0; i < memory_.loads.motions.size(); ++i) {
        if (memory_.loads.motions[i].block != block) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        memory_.loads.motions.erase(memory_.loads.motions.begin() + at);
        memory_.motionSources.erase(memory_.motionSources.begin() + at);
        memory_.start.motions.erase(memory_.start.motions.begin() + at);
        break;
    }
    const PrescribedMotion prescribed{block, motion.axis.normalized(), motion.rotation == Rotation::Held};
    turnUnknowns(state.blocks[block], prescribed.axis);
    memory_.loads.motions.push_back(prescribed);
    memory_.motionSources.push_back({memory_.stage, row});
    memory_.start.motions.push_back(displacementAlong(model_, state, prescribed));
}

void StageLoads::begin(int stage, State& state) {
    memory_.stage = stage;
    forgetReplaced();
    if (this->stage().zeroDisplacements) {
        memory_.zero.clear();
        for (const BlockMotion& block : state.blocks) memory_.zero.push_back(block.centroid);
    }
    for (int row = 0; row < static_cast<int>(this->stage().loads.size()); ++row) addLoad(row, state);
    for (int row = 0; row < static_cast<int>(this->stage().motions.size()); ++row) addMotion(row, state);
    if (!this->stage().dilations.empty()) memory_.start.openings.resize(model_.openings, 0.0);
    memory_.start.time = 0.0;
    if (!keepsAcceleration()) memory_.start.acceleration = {0.0, 0.0};
}

/// True if the stage starts with the body acceleration of the previous one. This requires a static stage before it. The
/// stage itself must be static, and then changes the acceleration in proportion, or follow a collapse.
bool StageLoads::keepsAcceleration() const {
    const bool follows = memory_.stage > 0;
    const bool takesOver = stage().kind == StageKind::Static || stage().followsCollapse;
    return follows && takesOver && stageAt(memory_.stage - 1).kind == StageKind::Static;
}

void StageLoads::hold(const std::vector<WallForce>& walls) {
    assert(stage().kind == StageKind::Static || stage().relaxation);
    addWalls(walls, memory_.stage);
}

void StageLoads::addWalls(const std::vector<WallForce>& walls, int stage) {
    for (const WallForce& wall : walls) {
        memory_.loads.walls.push_back(wall);
        memory_.wallStages.push_back(stage);
        memory_.start.walls.push_back(1.0);
    }
}

void StageLoads::quieten(const std::vector<Dashpot>& dashpots, const std::vector<WallForce>& kept) {
    std::vector<char> drop;
    for (int stage : memory_.wallStages) drop.push_back(stage < 0);
    dropRows(drop, memory_.loads.walls, memory_.wallStages, memory_.start.walls);
    memory_.loads.dashpots = dashpots;
    addWalls(kept, -1);
}

/// Fraction of a wall's force that still acts at the end of the stage.
double StageLoads::wallAtEnd(std::size_t wall) const {
    const double now = memory_.start.walls[wall];
    if (stage().kind == StageKind::Dynamic && !stage().relaxation) return now;
    if (memory_.wallStages[wall] < 0) return now;
    const bool own = memory_.wallStages[wall] == memory_.stage;
    if (!own && !stage().relaxation) return now;
    return std::min(now, 1.0 - stage().relaxation.value_or(1.0));
}

void StageLoads::forgetAbsent(const State& state) {
    const auto gone = [&](const auto& rows) {
        std::vector<char> drop;
        for (const auto& row : rows) drop.push_back(row.block >= 0 && state.blocks[row.block].absent);
        return drop;
    };
    Loads& loads = memory_.loads;
    LoadPoint& start = memory_.start;
    dropRows(gone(loads.forces), loads.forces, memory_.forceSources, start.forces);
    dropRows(gone(loads.pressures), loads.pressures, memory_.pressureSources, start.pressures);
    dropRows(gone(loads.motions), loads.motions, memory_.motionSources, start.motions);
    std::vector<char> walls = gone(loads.walls);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const int bolt = loads.walls[i].bolt;
        walls[i] = walls[i] || start.walls[i] == 0.0 || (bolt >= 0 && state.bolts[bolt].absent);
    }
    dropRows(walls, loads.walls, memory_.wallStages, start.walls);
}

/// Removes loads that have faded out; some remain if a stage ended early.
void StageLoads::forgetReplaced() {
    const auto gone = [](const std::vector<LoadSource>& sources, const std::vector<double>& values) {
        std::vector<char> drop;
        for (std::size_t i = 0; i < sources.size(); ++i) drop.push_back(sources[i].replaced && values[i] == 0.0);
        return drop;
    };
    Loads& loads = memory_.loads;
    LoadPoint& start = memory_.start;
    dropRows(gone(memory_.forceSources, start.forces), loads.forces, memory_.forceSources, start.forces);
    dropRows(gone(memory_.pressureSources, start.pressures), loads.pressures, memory_.pressureSources, start.pressures);
}

/// Displacement of the block along the axis of its motion from its start to the point at which displacements were last
/// reset.
double StageLoads::zeroOf(const PrescribedMotion& motion) const {
    const std::size_t block = motion.block;
    return memory_.zero.empty() ? 0.0 : motion.axis.dot(memory_.zero[block] - model_.blocks[block].centroid);
}

/// Adds the opening of joints over this stage to that of earlier stages.
void StageLoads::addOpenings(double time, LoadPoint& point) const {
    for (const Dilation& dilation : stage().dilations) {
        const std::size_t byName = model_.joints.size() + static_cast<std::size_t>(std::max(0, dilation.source));
        if (dilation.source >= 0) point.openings[byName] += dilation.rate * time;
        for (std::size_t joint = 0; joint < scene_.jointMaterials.size() && dilation.source < 0; ++joint)
            if (scene_.jointMaterials[joint].first == dilation.joint) point.openings[joint] += dilation.rate * time;
    }
}

Point StageLoads::bodyAccelerationAt(double time) const {
    const Point own = bodyForceAt(stage(), time), &before = memory_.start.acceleration;
    if (stage().followsCollapse) return before;
    if (stage().kind == StageKind::Dynamic || time >= 1.0) return own;
    return before + std::max(time, 0.0) * (own - before);
}

LoadPoint StageLoads::at(double time) const {
    LoadPoint point = memory_.start;
    point.time = time;
    point.gravity = 1.0;
    point.acceleration = bodyAccelerationAt(time);
    const auto fill = [&](std::vector<double>& values, const std::vector<LoadSource>& sources) {
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (sources[i].replaced) values[i] = 0.0;
            else if (sources[i].stage == memory_.stage) values[i] = valueAt(tableOf(loadOf(sources[i]).table), time);
    };
    fill(point.forces, memory_.forceSources);
    fill(point.pressures, memory_.pressureSources);
    for (std::size_t i = 0; i < memory_.motionSources.size(); ++i) {
        if (memory_.motionSources[i].stage != memory_.stage) continue;
        const Table& table = stage().motions[memory_.motionSources[i].row].table;
        point.motions[i] = zeroOf(memory_.loads.motions[i]) + valueAt(table, time);
    }
    addOpenings(time, point);
    const double whole = stage().kind == StageKind::Dynamic ? stage().duration : 1.0;
    const double share = whole > 0.0 ? std::clamp(time / whole, 0.0, 1.0) : 1.0;
    for (std::size_t i = 0; i < point.walls.size(); ++i) point.walls[i] += share * (wallAtEnd(i) - point.walls[i]);
    return point;
}

/// Tables of this stage for the loads and motions that act.
std::vector<const Table*> StageLoads::tables() const {
    std::vector<const Table*> found;
    for (const auto* sources : {&memory_.forceSources, &memory_.pressureSources})
        for (const LoadSource& source : *sources)
            if (source.stage == memory_.stage) found.push_back(&tableOf(loadOf(source).table));
    for (const LoadSource& source : memory_.motionSources)
        if (source.stage == memory_.stage)
            found.push_back(&stage().motions[source.row].table);
    return found;
}

std::vector<double> StageLoads::turns() const {
    std::vector<double> times;
    for (const Table* table : tables())
        for (const auto& [time, value] : *table)
            if (time > 0.0 && time < 1.0) times.push_back(time);
    return times;
}

bool StageLoads::varies() const {
    const std::vector<const Table*> all = tables();
    if (!stage().dilations.empty()) return true;
    if (stage().kind == StageKind::Static && bodyAccelerationAt(0.0) != bodyAccelerationAt(1.0)) return true;
    for (std::size_t i = 0; i < memory_.start.walls.size(); ++i)
        if (wallAtEnd(i) != memory_.start.walls[i]) return true;
    return std::any_of(all.begin(), all.end(), [](const Table* table) { return changes(*table); });
}

}  // namespace keyblock
