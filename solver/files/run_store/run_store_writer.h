// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the results of a run to a store on disk as they are produced. The store is
// one SQLite file in write-ahead mode. Each frame is one transaction, so a run killed
// at any moment leaves all committed frames, and others can read the store during the
// run. The latest checkpoint is stored together with the results up to it. When the
// run ends, the write-ahead file is merged and a single file remains.
#pragma once

#include "solver/run/write_error.h"
#include "solver/run/sink.h"

#include <chrono>
#include <filesystem>
#include <memory>

namespace keyblock {

/// Thrown if the file already exists and must not be replaced.
struct StoreExists : CannotWrite {
    using CannotWrite::CannotWrite;
};

/// Checks that a store may be written to `path`: there is no file at `path`, or `overwrite` is true and the file is
/// empty or a run store. \throws StoreExists otherwise.
void requireFreeStore(const std::filesystem::path& path, bool overwrite);

class RunStoreWriter : public Sink {
public:
    /// Writes nothing yet; `begin` creates the store and writes the scene to it.
    /// \param patience how long a write waits while another program has the store locked.
    /// \throws StoreExists if no store may be written to `path` (see `requireFreeStore`).
    RunStoreWriter(std::filesystem::path path, bool overwrite,
                   std::chrono::milliseconds patience = std::chrono::minutes(1));
    /// Closes the store if it is still open. Results that can no longer be written are lost; nothing is thrown.
    ~RunStoreWriter() override;
    RunStoreWriter(const RunStoreWriter&) = delete;
    RunStoreWriter& operator=(const RunStoreWriter&) = delete;

    // Each function throws CannotWrite on failure; the store then keeps what was committed before. So does a function that
    // finds that the store is no longer the file at its path; the results so far are then kept in another file.
    void begin(const Scene& scene, const HistoryColumns& columns) override;
    /// Continues the existing store. \pre the store belongs to this scene, and `from` was read from the store.
    void resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from) override;
    void stageBegins(int stage) override;
    void event(const Event& event) override;
    void history(const HistoryRow& row) override;
    void frame(const Frame& frame) override;
    void stageEnds(const StageResult& result) override;
    /// Stores the checkpoint, together with all results received since the last transaction, in a single transaction.
    /// The checkpoint is deleted when the run is complete.
    void checkpoint(const Checkpoint& checkpoint) override;

    /// Commits all results received since the last frame and closes the store, which leaves a single file.
    /// \throws CannotWrite
    void close();

private:
    struct Open;

    template <typename Work>
    void write(Work work);
    [[noreturn]] void leaveLostStore();
    void putStage(Open& open, int stage) const;

    std::filesystem::path path_;
    bool overwrite_;
    std::chrono::milliseconds patience_;
    Scene scene_;
    std::unique_ptr<Open> open_;
};

}  // namespace keyblock
