// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the command line share: a folder of their own, and two scenes
// that run in a moment.
#pragma once

#include "tests/cli/program.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

namespace keyblock::test {

class CommandLine : public ::testing::Test {
protected:
    const std::filesystem::path& folder() const { return folder_.path(); }
    Ended keyblock(const std::vector<std::string>& words,
                   const std::map<std::string, std::string>& environment = {}) const {
        return run(words, folder(), environment);
    }

    /// A short bolt across a joint that opens until bonds let go: `pull.json`.
    void putPullScene() const;
    /// A block that rests on another for ten million steps: `rest.json`.
    void putEndlessScene() const;
    void put(const std::string& name, const std::string& text) const { putContent(folder() / name, text); }
    std::string content(const std::string& name) const { return contentOf(folder() / name); }
    bool exists(const std::string& name) const { return std::filesystem::exists(folder() / name); }
    /// Waits until `run`, which may be in progress, has more than `frames` frames; false if it does not get there.
    bool waitForFrames(const std::string& run, std::size_t frames = 0) const;
    /// Lines of a text, without their ends.
    static std::vector<std::string> lines(const std::string& text);
    /// Exports a table of `run` and returns its bytes.
    std::string table(const std::string& run, const std::string& name, const std::vector<std::string>& more = {}) const;

private:
    const ScratchFolder folder_;
};

}  // namespace keyblock::test
