// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One read transaction lasts as long as the reader, so that events, history and frames
// are consistent however fast the run continues. Values from the file are checked
// before they are used as indices.
#include "solver/files/run_store/run_store.h"

#include "solver/files/read_error.h"
#include "solver/files/run_store/run_schema.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/run_store/store_reading.h"
#include "solver/results/history.h"
#include "solver/results/result_names.h"
#include "solver/scene/collapse_stage.h"
#include "solver/scene/solved_blocks.h"

#include <sqlite3.h>

#include <cassert>

namespace keyblock {

namespace {

namespace fs = std::filesystem;
using namespace store_reading;

/// Converts an index that was stored as a double.
int storedIndex(double value, std::size_t end) {
    if (!(value >= 0.0 && value < static_cast<double>(end)))
        outOfRange();
    return static_cast<int>(value);
}

constexpr std::size_t anyNumber = 1000000000;

Event eventAt(const sqlite::Statement& row, const Scene& scene, std::size_t blocks) {
    Event event;
    event.stage = indexBelow(row.integer(0), 0, scene.stages.size());
    event.time = row.real(1);
    event.step = static_cast<long>(row.integer(2));
    event.kind = known(eventKindOf(row.text(3)));
    event.bolt = indexBelow(row.integer(4), -1, scene.bolts.size());
    event.node = indexBelow(row.integer(5), -1, anyNumber);
    event.element = indexBelow(row.integer(6), -1, anyNumber);
    event.block = indexBelow(row.integer(7), -1, blocks);
    event.otherBlock = indexBelow(row.integer(8), -1, blocks);
    event.position = {row.real(9), row.real(10)};
    event.axialForce = row.real(11);
    event.shearForce = row.real(12);
    event.anchorForce = row.real(13);
    event.slip = row.real(14);
    event.historyRow = indexBelow(row.integer(15), -1, anyNumber);
    event.cause = indexBelow(row.integer(16), -1, anyNumber);
    return event;
}

/// \param values four per block, as listed in table `columns`.
std::vector<UnstableBlock> unstableBlocks(const std::vector<double>& values, std::size_t blocks) {
    constexpr int modes = static_cast<int>(Movement::Follows) + 1;
    std::vector<UnstableBlock> unstable;
    for (std::size_t i = 0; i + 3 < values.size(); i += 4)
        unstable.push_back({storedIndex(values[i], blocks),
                            static_cast<Movement>(storedIndex(values[i + 1], modes)), values[i + 2], values[i + 3]});
    return unstable;
}

StageRecord stageAt(const sqlite::Statement& row, const Scene& scene, std::size_t blocks) {
    StageRecord record;
    record.result.stage = indexBelow(row.integer(0), 0, scene.stages.size());
    record.ended = !row.isNull(1);
    if (!record.ended)
        return record;
    StageResult& result = record.result;
    result.outcome = known(outcomeOf(row.text(1)));
    result.time = row.real(2);
    result.steps = static_cast<long>(row.integer(3));
    result.message = row.text(4);
    for (const double block : known(row.doubles(5)))
        result.blocks.push_back(storedIndex(block, blocks));
    result.health.steps = static_cast<long>(row.integer(18));
    result.health.passes = static_cast<long>(row.integer(6));
    result.health.stepCuts = static_cast<long>(row.integer(7));
    result.health.energyCuts = static_cast<long>(row.integer(8));
    StepWork& work = result.health.work;
    int column = 9;
    for (long* count : {&work.factorizations, &work.fullFactorizations, &work.ranks, &work.solves, &work.products,
                        &work.sweeps})
        *count = static_cast<long>(row.integer(column++));
    result.health.maxPenetrationRatio = row.real(15);
    result.health.maxResidual = row.real(16);
    result.health.balanceError = row.real(17);
    result.unstable = unstableBlocks(known(row.doubles(19)), blocks);
    if (const auto farthest = unstableBlocks(known(row.doubles(20)), blocks); !farthest.empty())
        result.farthest = farthest.front();
    for (const double block : known(row.doubles(21)))
        result.loose.push_back(storedIndex(block, blocks));
    result.health.worst = {indexBelow(row.integer(22), -1, blocks), row.real(23), row.real(24)};
    result.health.awake = static_cast<long>(row.integer(25));
    result.health.movable = static_cast<long>(row.integer(26));
    return record;
}

}  // namespace

/// Executes `work` and reports SQLite errors as a file that cannot be read.
template <typename Work>
auto RunStore::guarded(Work work) const {
    try {
        return work();
    } catch (const sqlite::Error&) {
        cannotRead(path_, damaged);
    }
}

RunStore::RunStore(const fs::path& path) : path_(path), database_(opened(path)) {
    guarded([&] {
        requireRunStore(database_, path_);
        readAbout();
        readColumns();
        readHeads();
    });
}

void RunStore::readAbout() {
    sceneHash_ = aboutValue(database_, "scene_hash");
    programVersion_ = aboutValue(database_, "program_version");
    SceneReading reading = readSceneText(aboutValue(database_, "scene"), path_.string() + " (scene)");
    if (!reading.scene) {
        const std::string first = reading.problems.empty() ? "" : " (" + oneLine(reading.problems.front()) + ")";
        cannotRead(path_, "this program does not accept the scene in it" + first + "; run the scene again");
    }
    scene_ = withCollapseStages(std::move(reading.cut ? reading.cut->scene : *reading.scene));
    names_ = keyblock::blockNames(scene_);
    corners_ = cornerCounts(scene_);
}

void RunStore::readColumns() {
    sqlite::Statement statement(database_, "SELECT name FROM columns WHERE payload='history' ORDER BY position");
    while (statement.next())
        columns_.names.push_back(statement.text(0));
    columns_.monitorValues = historyColumns(scene_).monitorValues;
    if (columns_ != historyColumns(scene_))
        cannotRead(path_, damaged);
}

void RunStore::readHeads() {
    sqlite::Statement statement(database_, std::string("SELECT ") + headColumns + ", frame FROM frames ORDER BY frame");
    while (statement.next()) {
        heads_.push_back(headAt(statement, scene_));
        frameKeys_.push_back(statement.integer(14));
    }
}

std::vector<StageRecord> RunStore::stages() const {
    return guarded([&] {
        std::vector<StageRecord> records;
        sqlite::Statement statement(database_,
                                    "SELECT stage, outcome, time, steps, message, blocks, passes, step_cuts, "
                                    "energy_cuts, factorizations, full_factorizations, ranks, solves, products, sweeps, "
                                    "max_penetration_ratio, max_residual, balance_error, health_steps, "
                                    "unstable, farthest, loose, worst_block, worst_share, worst_force, awake, movable "
                                    "FROM stages ORDER BY stage");
        while (statement.next())
            records.push_back(stageAt(statement, scene_, names_.size()));
        return records;
    });
}

std::vector<Event> RunStore::events() const {
    return guarded([&] {
        std::vector<Event> events;
        sqlite::Statement statement(database_,
                                    "SELECT stage, time, step, kind, bolt, node, element, block, other_block, x, y, "
                                    "axial_force, shear_force, anchor_force, slip, history_row, cause FROM events "
                                    "ORDER BY event");
        while (statement.next())
            events.push_back(eventAt(statement, scene_, names_.size()));
        return events;
    });
}

std::vector<HistoryRow> RunStore::history() const {
    return guarded([&] {
        std::vector<HistoryRow> rows;
        sqlite::Statement statement(database_, "SELECT stage, time, step, \"values\" FROM history ORDER BY row");
        while (statement.next()) {
            HistoryRow row;
            row.stage = indexBelow(statement.integer(0), 0, scene_.stages.size());
            row.time = statement.real(1);
            row.step = static_cast<long>(statement.integer(2));
            row.values = known(statement.doubles(3));
            if (row.values.size() != columns_.names.size())
                cannotRead(path_, damaged);
            rows.push_back(std::move(row));
        }
        return rows;
    });
}

Frame RunStore::frame(std::size_t index) const {
    assert(index < heads_.size());
    return guarded([&] { return frameAt(database_, frameKeys_.at(index), scene_, corners_, heads_.at(index)); });
}

std::optional<StoredCheckpoint> RunStore::checkpoint() const {
    return guarded([&]() -> std::optional<StoredCheckpoint> {
        sqlite::Statement statement(database_, "SELECT build, hash, state FROM checkpoint");
        if (!statement.next())
            return std::nullopt;
        return StoredCheckpoint{statement.text(0), statement.text(1), statement.bytes(2)};
    });
}

Results readResults(const RunStore& store) {
    Results results;
    results.columns = store.columns();
    results.history = store.history();
    results.events = store.events();
    for (std::size_t index = 0; index < store.frames().size(); ++index)
        results.frames.push_back(store.frame(index));
    for (const StageRecord& record : store.stages())
        if (record.ended)
            results.stages.push_back(record.result);
    return results;
}

}  // namespace keyblock
