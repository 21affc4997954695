// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file is there whole, or as it was before.
#include "solver/files/atomic_file.h"

#include "solver/run/write_error.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <stdexcept>

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
