// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a run into a store on disk while it runs. The store is one SQLite file in
// write-ahead mode: each frame is one transaction, so a run that is killed at any
// moment leaves every frame it had committed, and others may read meanwhile. The
// newest checkpoint lies with the results that belong to it. When the run ends the
// write-ahead file is folded in and one plain file is left.
#pragma once

#include "solver/run/write_error.h"
#include "solver/run/sink.h"

#include <filesystem>
#include <memory>

namespace keyblock {

/// A store of that name is there already and may not be replaced.
struct StoreExists : CannotWrite {
    using CannotWrite::CannotWrite;
};

/// \throws StoreExists unless nothing is at `path`, or `overwrite` is set and a run store (or an empty file) is.
void requireFreeStore(const std::filesystem::path& path, bool overwrite);

class RunStoreWriter : public Sink {
public:
    /// Writes nothing yet: the store appears with `begin`, the scene already in it. \throws StoreExists
    RunStoreWriter(std::filesystem::path path, bool overwrite);
    /// Closes the store if that was not done; what cannot be written any more is left out.
    ~RunStoreWriter() override;
    RunStoreWriter(const RunStoreWriter&) = delete;
    RunStoreWriter& operator=(const RunStoreWriter&) = delete;

    // Each throws CannotWrite and leaves the store with what was committed before.
    void begin(const Scene& scene, const HistoryColumns& columns) override;
    /// Continues in the existing store. \pre it is of that scene, and `from` was read from it.
    void resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from) override;
    void stageBegins(int stage) override;
    void event(const Event& event) override;
    void history(const HistoryRow& row) override;
    void frame(const Frame& frame) override;
    void stageEnds(const StageResult& result) override;
    /// One transaction with everything that came since the last; the last stage's end takes it away again.
    void checkpoint(const Checkpoint& checkpoint) override;

    /// Commits what came since the last frame and leaves one plain file. \throws CannotWrite
    void close();

private:
    struct Open;

    template <typename Work>
    void write(Work work);

    std::filesystem::path path_;
    bool overwrite_;
    Scene scene_;
    std::unique_ptr<Open> open_;
};

}  // namespace keyblock
