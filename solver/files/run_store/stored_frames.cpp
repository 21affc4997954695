// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/stored_frames.h"

#include "solver/files/run_store/run_schema.h"
#include "solver/files/run_store/store_reading.h"
#include "solver/scene/solved_blocks.h"

#include <utility>

namespace keyblock {

StoredFrames::StoredFrames(std::filesystem::path path, std::shared_ptr<const Scene> solved)
    : path_(std::move(path)), solved_(std::move(solved)), corners_(cornerCounts(*solved_)) {}

Frame StoredFrames::frame(std::size_t index) const {
    using namespace store_reading;
    const sqlite::Database database = openedAgain(path_);
    try {
        requireRunStore(database, path_);
        const auto key = static_cast<std::int64_t>(index) + 1;  // the writer numbers frames from 1, without gaps
        sqlite::Statement statement(database, selectChecked(run_schema::headColumns, "FROM frames WHERE frame=?"));
        statement.bind(key);
        if (!nextChecked(statement, headWidth))
            cannotRead(path_, "it no longer has frame " + std::to_string(key) + "; open the run again");
        return frameAt(database, key, *solved_, corners_, headAt(statement, *solved_));
    } catch (const sqlite::Error&) {
        cannotRead(path_, damaged);
    }
}

}  // namespace keyblock
