// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file is there whole, or as it was before.
#include "solver/files/atomic_file.h"

#include "solver/files/part_folder.h"
#include "solver/run/write_error.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

std::size_t filesIn(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(AtomicFile, ReplacesTheOldOneAndLeavesNothingElse) {
    const test::ScratchFolder folder;
    const fs::path file = folder.path() / "table.csv";
    writeAtomically(file, [](std::ostream& out) { out << "old"; });
    writeAtomically(file, [](std::ostream& out) { out << "new"; });
    EXPECT_EQ(test::contentOf(file), "new");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, KeepsTheOldOneWhenWritingFails) {
    const test::ScratchFolder folder;
    const fs::path file = folder.path() / "table.csv";
    writeAtomically(file, [](std::ostream& out) { out << "old"; });
    EXPECT_THROW(writeAtomically(file,
                                [](std::ostream& out) {
                                    out << "half";
                                    throw std::runtime_error("stopped");
                                }),
                 std::runtime_error);
    EXPECT_THROW(writeAtomically(file, [](std::ostream& out) { out.setstate(std::ios::badbit); }), CannotWrite);
    EXPECT_EQ(test::contentOf(file), "old");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, FollowsALink) {
    const test::ScratchFolder folder;
    const fs::path link = folder.path() / "link.csv";
    fs::create_symlink("table.csv", link);
    writeAtomically(link, [](std::ostream& out) { out << "text"; });
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(test::contentOf(folder.path() / "table.csv"), "text");
}

/// A user with write permission for the folder could place a link to another user's file at the temporary name.
TEST(AtomicFile, FollowsNoLinkAtItsTemporaryName) {
    const test::ScratchFolder folder;
    const fs::path file = folder.path() / "table.csv", other = folder.path() / "other";
    test::putContent(other, "precious");
    for (const bool empty : {false, true}) {
        fs::create_symlink(other, partPath(file));
        if (empty) fs::rename(makePartFile(file), file);
        else writeAtomically(file, [](std::ostream& out) { out << "text"; });
        EXPECT_EQ(test::contentOf(other), "precious");
        EXPECT_FALSE(fs::is_symlink(file));
        EXPECT_EQ(test::contentOf(file), empty ? "" : "text");
    }
}

/// A process that has ended and been waited for.
std::string endedProcess() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return std::to_string(child);
}

TEST(AtomicFile, RemovesWhatKilledProcessesLeft) {
    const test::ScratchFolder folder;
    const auto at = [&](const std::string& name) { return folder.path() / name; };
    const std::string gone = endedProcess(), alive = std::to_string(::getppid());
    test::putContent(at("table.csv.part-" + gone), "half");
    test::putContent(at("table.csv.part-" + gone + "-journal"), "half");
    fs::create_directories(at("frames.part-" + gone + "/inside"));
    const std::vector<std::string> kept{"table.csv.part-" + alive, "other.csv.part-" + gone, "table.csv.part-x",
                                        "table.csv.part-" + gone + "-old", "table.csv.part-"};
    for (const std::string& name : kept) test::putContent(at(name), "kept");
    writeAtomically(at("table.csv"), [](std::ostream& out) { out << "text"; });
    PartFolder(at("frames"), [](const std::string&) { return true; }).putInPlace();
    for (const std::string& name : kept) EXPECT_TRUE(fs::exists(at(name))) << name;
    EXPECT_EQ(filesIn(folder.path()), kept.size() + 2);
}

TEST(AtomicFile, SaysWhereItCannotWrite) {
    const test::ScratchFolder folder;
    try {
        writeAtomically(folder.path() / "missing" / "table.csv", [](std::ostream& out) { out << "text"; });
        FAIL() << "wrote into a folder that is not there";
    } catch (const CannotWrite& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("missing/table.csv"), std::string::npos) << message;
        EXPECT_NE(message.find("No such file"), std::string::npos) << message;
    }
    EXPECT_THROW(writeAtomically("/dev/full", [](std::ostream& out) { out << "text"; }), CannotWrite);
}

}  // namespace
}  // namespace keyblock
