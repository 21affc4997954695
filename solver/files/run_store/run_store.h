// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run read from its store. It shows the run as it was when the store was opened,
// even if another process is still writing it; open the store again to see later
// results.
#pragma once

#include "solver/files/run_store/sqlite.h"
#include "solver/results/run_source.h"
#include "solver/run/checkpoint.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// A checkpoint as stored, before decoding.
struct StoredCheckpoint {
    std::string build;  // name of the build that wrote it
    std::string kernel;  // of OpenBLAS, with which the run was begun; empty: of another build
    std::string hash;  // SHA-256 of the state
    std::string state;
};

class RunStore : public RunSource {
public:
    /// Opens a store and reads its scene and the list of its frames.
    /// \throws CannotRead if the file is missing, is not a run store, has another version or is damaged.
    explicit RunStore(const std::filesystem::path& path);

    // Each function throws CannotRead if the store turns out to be damaged.
    const Scene& scene() const override { return scene_; }
    const std::vector<std::string>& blockNames() const override { return names_; }
    const HistoryColumns& columns() const override { return columns_; }
    std::vector<StageRecord> stages() const override { return stages_; }
    std::vector<Event> events() const override;
    std::vector<HistoryRow> history() const override;
    const std::vector<FrameHead>& frames() const override { return heads_; }
    Frame frame(std::size_t index) const override;

    /// The latest checkpoint; none if no checkpoint has been stored yet or the run is complete.
    std::optional<StoredCheckpoint> checkpoint() const;

    /// True if results may be missing because the store of an unfinished run was copied without its write-ahead file.
    bool mayLackResults() const { return lacksJournal_ && !isFinished(*this); }

    const std::string& sceneHash() const { return sceneHash_; }  // SHA-256 of the scene's text, 64 hexadecimal digits
    const std::string& programVersion() const { return programVersion_; }  // version that wrote the store

private:
    template <typename Work>
    auto guarded(Work work) const;
    void readAbout();
    void readColumns();
    void readStages();
    void readHeads();

    std::filesystem::path path_;
    bool lacksJournal_;  // before the store is opened, which may create one
    sqlite::Database database_;
    Scene scene_;
    std::vector<std::string> names_;
    std::vector<std::size_t> corners_;  // number for each block
    HistoryColumns columns_;
    std::string sceneHash_;
    std::string programVersion_;
    std::vector<StageRecord> stages_;
    Written atLeast_;  // number of results at the end of the last stage that has ended
    std::vector<FrameHead> heads_;
};

/// Reads all results of a store into memory. \throws CannotRead if the store is damaged.
Results readResults(const RunStore& store);

}  // namespace keyblock
