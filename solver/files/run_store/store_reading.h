// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run store is opened for reading and a frame unpacked, for all who read one.
// What comes out of the file is checked before it is used as an index.
#pragma once

#include "solver/files/run_store/sqlite.h"
#include "solver/results/run_source.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace keyblock::store_reading {

inline constexpr const char* damaged = "the store is damaged; run the scene again with --overwrite";

/// \throws CannotRead with path and reason.
[[noreturn]] void cannotRead(const std::filesystem::path& path, const std::string& reason);

/// Opens a store, with a read transaction begun. \throws CannotRead for what is missing or no database.
sqlite::Database opened(const std::filesystem::path& path);

/// The same for a file that is known to be a store, perhaps one that this process writes: it is touched by SQLite alone,
/// because closing a file in any other way takes the writer's locks off.
sqlite::Database openedAgain(const std::filesystem::path& path);

/// \throws CannotRead for a database that is not a run store, or one of another version.
void requireRunStore(const sqlite::Database& database, const std::filesystem::path& path);

/// A value of table `about`; empty when there is none.
std::string aboutValue(const sqlite::Database& database, std::string_view key);

// Each throws `sqlite::Error` where the store is damaged.

/// The stored index; it leads somewhere.
int indexBelow(std::int64_t value, std::int64_t first, std::size_t end);
[[noreturn]] void outOfRange();
template <typename Value>
Value known(const std::optional<Value>& value) {
    if (!value)
        outOfRange();
    return *value;
}

/// Columns of a frame that `headAt` reads, in its order.
inline constexpr const char* headColumns =
    "stage, time, step, kinetic, strain, contact, bolt, friction, plastic, released, damped, external, "
    "balance_error, events";
FrameHead headAt(const sqlite::Statement& row, const Scene& scene);

/// The frame stored under `key`.
Frame frameAt(const sqlite::Database& database, std::int64_t key, const Scene& scene, std::size_t blocks,
              const FrameHead& head);

}  // namespace keyblock::store_reading
