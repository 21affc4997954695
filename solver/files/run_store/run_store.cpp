// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One read transaction lasts as long as the reader, so that events, history and frames
// are consistent however fast the run continues. Values from the file are checked
// before they are used as indices.
#include "solver/files/run_store/run_store.h"

#include "solver/files/read_error.h"
#include "solver/files/run_store/checkpoint_bytes.h"
#include "solver/files/run_store/run_schema.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/run_store/store_reading.h"
#include "solver/results/history.h"
#include "solver/results/result_names.h"
#include "solver/scene/collapse_stage.h"
#include "solver/scene/solved_blocks.h"

#include <sqlite3.h>

#include <algorithm>
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
    event.stage = indexBelow(row.integer(1), 0, scene.stages.size());
    event.time = row.real(2);
    event.step = static_cast<long>(row.integer(3));
    event.kind = known(eventKindOf(row.text(4)));
    event.bolt = indexBelow(row.integer(5), -1, scene.bolts.size());
    event.node = indexBelow(row.integer(6), -1, anyNumber);
    event.element = indexBelow(row.integer(7), -1, anyNumber);
    event.block = indexBelow(row.integer(8), -1, blocks);
    event.otherBlock = indexBelow(row.integer(9), -1, blocks);
    event.position = {row.real(10), row.real(11)};
    event.axialForce = row.real(12);
    event.shearForce = row.real(13);
    event.anchorForce = row.real(14);
    event.slip = row.real(15);
    event.historyRow = indexBelow(row.integer(16), -1, anyNumber);
    event.cause = indexBelow(row.integer(17), -1, anyNumber);
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

/// \param row a row of `run_schema::stageColumns`.
StageRecord stageAt(const sqlite::Statement& row, const Scene& scene, std::size_t blocks) {
    StageRecord record;
    record.result.stage = indexBelow(row.integer(0), 0, scene.stages.size());
    record.ended = !row.isNull(3);
    if (!record.ended)
        return record;
    StageResult& result = record.result;
    result.outcome = known(outcomeOf(row.text(3)));
    result.time = row.real(4);
    result.steps = static_cast<long>(row.integer(5));
    result.message = row.text(6);
    for (const double block : known(row.doubles(7))) result.blocks.push_back(storedIndex(block, blocks));
    Health& health = result.health;
    StepWork& work = health.work;
    int column = 8;
    for (long* count : {&health.passes, &health.stepCuts, &health.energyCuts, &work.factorizations,
                        &work.fullFactorizations, &work.ranks, &work.solves, &work.products, &work.sweeps})
        *count = static_cast<long>(row.integer(column++));
    for (double* number : {&health.maxPenetrationRatio, &health.maxResidual, &health.balanceError})
        *number = row.real(column++);
    health.steps = static_cast<long>(row.integer(20));
    result.unstable = unstableBlocks(known(row.doubles(21)), blocks);
    if (const auto farthest = unstableBlocks(known(row.doubles(22)), blocks); !farthest.empty())
        result.farthest = farthest.front();
    for (const double block : known(row.doubles(23))) result.loose.push_back(storedIndex(block, blocks));
    health.worst = {indexBelow(row.integer(24), -1, blocks), row.real(25), row.real(26)};
    health.awake = static_cast<long>(row.integer(27));
    health.movable = static_cast<long>(row.integer(28));
    return record;
}

/// Throws unless the next of the rows that are numbered without gaps has this number.
void requireNumber(std::int64_t stored, std::size_t expected) {
    if (stored != static_cast<std::int64_t>(expected)) outOfRange();
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

RunStore::RunStore(const fs::path& path) : path_(path), lacksJournal_(lacksJournal(path)), database_(opened(path)) {
    guarded([&] {
        requireRunStore(database_, path_);
        readAbout();
        readColumns();
        readStages();
        readHeads();
    });
}

void RunStore::readAbout() {
    sceneHash_ = aboutValue(database_, "scene_hash");
    programVersion_ = aboutValue(database_, "program_version");
    SceneReading reading = readSceneText(aboutValue(database_, "scene"), path_.string() + " (scene)", {}, std::nullopt);
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

void RunStore::readStages() {
    sqlite::Statement rows(database_, selectChecked(run_schema::stageColumns, "FROM stages ORDER BY stage"));
    while (nextChecked(rows, stageWidth)) {
        stages_.push_back(stageAt(rows, scene_, names_.size()));
        if (stages_.back().ended)
            atLeast_ = {static_cast<long>(rows.integer(29)), static_cast<long>(rows.integer(30)),
                        static_cast<long>(rows.integer(31))};
    }
}

/// The order of the frames and of their stages also shows whether rows were lost.
void RunStore::readHeads() {
    sqlite::Statement rows(database_, selectChecked(run_schema::headColumns, "FROM frames ORDER BY frame"));
    while (nextChecked(rows, headWidth)) {
        requireNumber(rows.integer(0), heads_.size() + 1);
        heads_.push_back(headAt(rows, scene_));
    }
    const auto lastStage = stages_.empty() ? -1 : stages_.back().result.stage;
    if (static_cast<long>(heads_.size()) < atLeast_.frames || (!heads_.empty() && heads_.back().stage > lastStage))
        outOfRange();
}

std::vector<Event> RunStore::events() const {
    return guarded([&] {
        std::vector<Event> events;
        sqlite::Statement rows(database_, selectChecked(run_schema::eventColumns, "FROM events ORDER BY event"));
        while (nextChecked(rows, eventWidth)) {
            requireNumber(rows.integer(0), events.size() + 1);
            events.push_back(eventAt(rows, scene_, names_.size()));
        }
        const long ofFrames = heads_.empty() ? 0 : heads_.back().events;
        if (static_cast<long>(events.size()) < std::max(atLeast_.events, ofFrames)) outOfRange();
        return events;
    });
}

std::vector<HistoryRow> RunStore::history() const {
    return guarded([&] {
        std::vector<HistoryRow> history;
        sqlite::Statement rows(database_, selectChecked(run_schema::historyColumns, "FROM history ORDER BY row"));
        while (nextChecked(rows, historyWidth)) {
            requireNumber(rows.integer(0), history.size());
            HistoryRow row;
            row.stage = indexBelow(rows.integer(1), 0, scene_.stages.size());
            row.time = rows.real(2);
            row.step = static_cast<long>(rows.integer(3));
            row.values = known(rows.doubles(4));
            if (row.values.size() != columns_.names.size()) outOfRange();
            history.push_back(std::move(row));
        }
        if (static_cast<long>(history.size()) < atLeast_.historyRows) outOfRange();
        return history;
    });
}

Frame RunStore::frame(std::size_t index) const {
    assert(index < heads_.size());
    return guarded(
        [&] { return frameAt(database_, static_cast<std::int64_t>(index) + 1, scene_, corners_, heads_.at(index)); });
}

std::optional<StoredCheckpoint> RunStore::checkpoint() const {
    return guarded([&]() -> std::optional<StoredCheckpoint> {
        sqlite::Statement statement(database_, "SELECT build, hash, state FROM checkpoint");
        if (!statement.next())
            return std::nullopt;
        const std::string build = statement.text(0);
        const std::string kernel = build == buildName() ? aboutValue(database_, "blas_kernel") : "";
        return StoredCheckpoint{build, kernel, statement.text(1), statement.bytes(2)};
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
