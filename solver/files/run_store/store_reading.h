// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opening a run store for reading and unpacking its frames; shared by all readers.
// Values from the file are checked before they are used as indices.
#pragma once

#include "solver/files/run_store/sqlite.h"
#include "solver/results/run_source.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace keyblock::store_reading {

inline constexpr const char* damaged = "the store is damaged; run the scene again with --overwrite";

/// True if the file is a store in write-ahead mode without its write-ahead file. SQLite then reads the results that had
/// been merged into it, which need not be all.
bool lacksJournal(const std::filesystem::path& path);

/// Throws CannotRead with a message that gives the path and the reason.
[[noreturn]] void cannotRead(const std::filesystem::path& path, const std::string& reason);

/// Opens a store and begins a read transaction. \throws CannotRead if the file is missing or is not a database.
sqlite::Database opened(const std::filesystem::path& path);

/// Opens a file that is known to be a store, possibly one to which this process is writing, and begins a read
/// transaction. The file is opened through SQLite only: closing it by other means would release the writer's locks.
/// \throws CannotRead
sqlite::Database openedAgain(const std::filesystem::path& path);

/// Checks that the database is a run store of the current version and has the tables of one and nothing else: no view,
/// trigger, index or virtual table. \throws CannotRead if it is not.
void requireRunStore(const sqlite::Database& database, const std::filesystem::path& path);

// Each of the following throws `sqlite::Error` if the store is damaged.

/// The value stored under `key` in the table `about`.
std::string aboutValue(const sqlite::Database& database, std::string_view key);

/// SQL that selects `columns`, a list of run_schema.h, and in the column after them their checksum.
std::string selectChecked(const std::string& columns, const std::string& rest, const char* checksum = "checksum");

/// Steps to the next row of a statement made by `selectChecked` and checks it.
/// \param columns the number of columns before that of the checksum.
bool nextChecked(sqlite::Statement& rows, int columns);

/// Checks that a stored index is at least `first` and less than `end`, and returns it.
int indexBelow(std::int64_t value, std::int64_t first, std::size_t end);
[[noreturn]] void outOfRange();
template <typename Value>
Value known(const std::optional<Value>& value) {
    if (!value)
        outOfRange();
    return *value;
}

/// Number of columns in each list of run_schema.h.
inline constexpr int stageWidth = 32, eventWidth = 18, historyWidth = 5, headWidth = 15, payloadWidth = 12;

/// The head of a frame in a row of `run_schema::headColumns`.
FrameHead headAt(const sqlite::Statement& row, const Scene& scene);

/// Reads the frame stored under `key`.
/// \param scene the scene as solved, i.e. after cutting.
/// \param corners number of corners of each block.
/// \param head the data of the frame that have already been read.
Frame frameAt(const sqlite::Database& database, std::int64_t key, const Scene& scene,
              std::span<const std::size_t> corners, const FrameHead& head);

}  // namespace keyblock::store_reading
