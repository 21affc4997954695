// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a search for the factor of safety leaves on disk: the runs nearest the
// bracket, so that the mechanism can be looked at, and a table of all runs.
#pragma once

#include "solver/files/part_folder.h"
#include "solver/run/safety.h"
#include "solver/run/sink.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace keyblock::cli {

/// `stands.kbrun`, `fails.kbrun` and `safety.csv` in a folder that appears whole.
class SafetyFolder {
public:
    /// \throws CannotWrite where the folder is there and may not be replaced, or holds something else.
    SafetyFolder(const std::filesystem::path& folder, bool overwrite);

    /// Runs into a store of its own and into `other`, which both get everything.
    void record(Sink& other, const std::function<void(Sink& both)>& run);

    /// Keeps the run last recorded where it is the nearest to the bracket so far.
    void keep(const SafetyRun& run);

    /// Writes the table of the runs that were kept and puts the folder in its place. \param scene as it was solved.
    void finish(const Scene& scene);

private:
    std::filesystem::path probe() const { return folder_.path() / "probe.kbrun"; }

    PartFolder folder_;
    std::vector<SafetyRun> runs_;
};

}  // namespace keyblock::cli
