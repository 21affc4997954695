// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of a search for the factor of safety on disk: the stable and the unstable
// run at the ends of the bracket, so that the failure mechanism can be examined, and a
// table of all runs.
#pragma once

#include "solver/files/part_folder.h"
#include "solver/run/safety.h"
#include "solver/run/sink.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace keyblock::cli {

/// Folder with `stands.kbrun`, `fails.kbrun` and `safety.csv`. The folder gets its final name once it is complete.
class SafetyFolder {
public:
    /// \throws CannotWrite if the folder exists and may not be replaced, or if it contains anything other than the
    /// files of an earlier search.
    SafetyFolder(const std::filesystem::path& folder, bool overwrite);

    /// Calls `run` with a sink that writes to both a new run store and `other`.
    void record(Sink& other, const std::function<void(Sink& both)>& run);

    /// Adds a run to the table. The store of the latest recorded run becomes `stands.kbrun` or `fails.kbrun`, unless
    /// the run is undecided.
    void keep(const SafetyRun& run);

    /// Writes the table and gives the folder its final name. \param scene the scene as solved, i.e. cut into blocks.
    void finish(const Scene& scene);

private:
    std::filesystem::path probe() const { return folder_.path() / "probe.kbrun"; }

    PartFolder folder_;
    std::vector<SafetyRun> runs_;
};

}  // namespace keyblock::cli
