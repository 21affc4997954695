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

/// Throws CannotRead with a message that gives the path and the reason.
[[noreturn]] void cannotRead(const std::filesystem::path& path, const std::string& reason);

/// Opens a store and begins a read transaction. \throws CannotRead if the file is missing or is not a database.
sqlite::Database opened(const std::filesystem::path& path);

/// Opens a file that is known to be a store, possibly one to which this process is writing, and begins a read
/// transaction. The file is opened through SQLite only: closing it by other means would release the writer's locks.
/// \throws CannotRead
sqlite::Database openedAgain(const std::filesystem::path& path);

/// Checks that the database is a run store of the current version. \throws CannotRead if it is not.
void requireRunStore(const sqlite::Database& database, const std::filesystem::path& path);

/// The value stored under `key` in the table `about`; empty if the table has no such key.
std::string aboutValue(const sqlite::Database& database, std::string_view key);

// Each of the following throws `sqlite::Error` if the store is damaged.

/// Checks that a stored index is at least `first` and less than `end`, and returns it.
int indexBelow(std::int64_t value, std::int64_t first, std::size_t end);
[[noreturn]] void outOfRange();
template <typename Value>
Value known(const std::optional<Value>& value) {
    if (!value)
        outOfRange();
    return *value;
}

/// Columns of the table `frames` in the order in which `headAt` reads them.
inline constexpr const char* headColumns =
    "stage, time, step, kinetic, strain, contact, bolt, friction, plastic, released, damped, external, "
    "balance_error, events";
FrameHead headAt(const sqlite::Statement& row, const Scene& scene);

/// Reads the frame stored under `key`.
/// \param scene the scene as solved, i.e. after cutting.
/// \param corners number of corners of each block.
/// \param head the data of the frame that have already been read.
Frame frameAt(const sqlite::Database& database, std::int64_t key, const Scene& scene,
              std::span<const std::size_t> corners, const FrameHead& head);

}  // namespace keyblock::store_reading
