// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/run_summary.h"

#include "solver/engine/step/blas_kernel.h"
#include "solver/files/run_store/checkpoint_bytes.h"
#include "solver/files/run_store/run_schema.h"
#include "solver/files/run_store/store_reading.h"
#include "solver/results/result_names.h"

namespace keyblock {

namespace {

/// Number of rows of a table whose rows are numbered from 1.
long countOf(const sqlite::Database& database, const std::string& table, const std::string& number) {
    sqlite::Statement statement(database, "SELECT ifnull(max(" + number + "), 0) FROM " + table);
    return statement.next() ? static_cast<long>(statement.integer(0)) : 0;
}

}  // namespace

RunSummary runSummary(const std::filesystem::path& store) {
    using namespace store_reading;
    const sqlite::Database database = opened(store);
    try {
        requireRunStore(database, store);
        RunSummary summary;
        summary.sceneHash = aboutValue(database, "scene_hash");
        summary.programVersion = aboutValue(database, "program_version");
        summary.frames = countOf(database, "frames", "frame");
        summary.events = countOf(database, "events", "event");
        sqlite::Statement stages(database, selectChecked(run_schema::stageColumns, "FROM stages ORDER BY stage"));
        while (nextChecked(stages, stageWidth)) {
            ++summary.stages;
            summary.stage = stages.text(1);
            summary.outcome = stages.isNull(3) ? std::nullopt : std::optional(known(outcomeOf(stages.text(3))));
            summary.message = stages.text(6);
        }
        sqlite::Statement checkpoint(database, "SELECT build FROM checkpoint");
        summary.resumable = checkpoint.next() && checkpoint.text(0) == buildName() &&
                            aboutValue(database, "blas_kernel") == blasKernel();
        return summary;
    } catch (const sqlite::Error&) {
        cannotRead(store, damaged);
    }
}

}  // namespace keyblock
