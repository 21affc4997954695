// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run read back from its store. It shows the run as it was when the store was
// opened, also while another process still writes it; open it again to see more.
#pragma once

#include "solver/files/run_store/sqlite.h"
#include "solver/results/run_source.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// As it lies in the store, not looked into.
struct StoredCheckpoint {
    std::string build;  // of the program that wrote it
    std::string hash;  // SHA-256 of the state
    std::string state;
};

class RunStore : public RunSource {
public:
    /// \throws CannotRead for a file that is missing, is not a run store, is of another version or is damaged.
    explicit RunStore(const std::filesystem::path& path);

    // Each throws CannotRead where the store turns out to be damaged.
    const Scene& scene() const override { return scene_; }
    const std::vector<std::string>& blockNames() const override { return names_; }
    const HistoryColumns& columns() const override { return columns_; }
    std::vector<StageRecord> stages() const override;
    std::vector<Event> events() const override;
    std::vector<HistoryRow> history() const override;
    const std::vector<FrameHead>& frames() const override { return heads_; }
    Frame frame(std::size_t index) const override;

    /// Null before the first and after the run's end.
    std::optional<StoredCheckpoint> checkpoint() const;

    const std::string& sceneHash() const { return sceneHash_; }  // SHA-256 of the scene's text, 64 hexadecimal digits
    const std::string& programVersion() const { return programVersion_; }  // of the program that wrote it

private:
    template <typename Work>
    auto guarded(Work work) const;
    void readAbout();
    void readColumns();
    void readHeads();

    std::filesystem::path path_;
    sqlite::Database database_;
    Scene scene_;
    std::vector<std::string> names_;
    HistoryColumns columns_;
    std::string sceneHash_;
    std::string programVersion_;
    std::vector<FrameHead> heads_;
    std::vector<std::int64_t> frameKeys_;  // of each head, in the store
};

/// Everything in a store at once.
Results readResults(const RunStore& store);

}  // namespace keyblock
