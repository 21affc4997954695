// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes, records and reference curves are read from regular files only; everything
// else is refused at once and by its name.
#include "solver/files/read_error.h"
#include "solver/files/scene/record_file.h"
#include "solver/files/scene/reference_file.h"
#include "solver/files/scene/scene_file.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

struct SpecialFile {
    std::string path, named;  // part of the message
};

class SpecialFiles : public ::testing::Test {
protected:
    SpecialFiles() {
        ::mkfifo(at("fifo").c_str(), 0600);
        fs::create_directory(at("folder"));
        fs::create_symlink("fifo", at("to_fifo"));
        fs::create_symlink("/dev/zero", at("to_device"));
        fs::create_symlink("folder", at("to_folder"));
        fs::create_symlink("nothing", at("to_nothing"));
        fs::create_symlink("loop", at("loop"));
        putSocket();
    }
    ~SpecialFiles() override { ::close(socket_); }

    fs::path at(const std::string& name) const { return folder_.path() / name; }

    std::vector<SpecialFile> all() const {
        return {{at("fifo"), "named pipe"},
                {at("to_fifo"), "named pipe"},
                {at("socket"), "socket"},
                {at("folder"), "folder"},
                {at("to_folder"), "folder"},
                {"/dev/zero", "device"},
                {"/dev/null", "device"},
                {"/dev/full", "device"},
                {"/dev/urandom", "device"},
                {"/dev/tty", "device"},
                {at("to_device"), "device"},
                {"/proc/self", "folder"},
                {at("to_nothing"), "No such file"},
                {at("loop"), "symbolic links"},
                {at("nothing"), "No such file"},
                {at("fifo") / "x", "Not a directory"},
                {at(std::string(300, 'x')), "too long"}};
    }

    const test::ScratchFolder folder_;

private:
    void putSocket() {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        at("socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
        socket_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
        ASSERT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    }

    int socket_ = -1;
};

TEST_F(SpecialFiles, AreRefusedAsScenesByName) {
    for (const auto& [path, named] : all()) {
        const SceneReading reading = readSceneFile(path);
        ASSERT_EQ(reading.problems.size(), 1u) << path;
        EXPECT_NE(reading.problems[0].message.find(named), std::string::npos) << path << reading.problems[0].message;
    }
}

TEST_F(SpecialFiles, AreRefusedAsRecordsByName) {
    for (const auto& [path, named] : all()) {
        const RecordReading reading = readRecordFile(path);
        ASSERT_EQ(reading.faults.size(), 1u) << path;
        EXPECT_NE(reading.faults[0].message.find(named), std::string::npos) << path << reading.faults[0].message;
    }
}

TEST_F(SpecialFiles, AreRefusedAsReferenceCurvesByName) {
    for (const auto& [path, named] : all()) {
        try {
            readReferenceFile(path);
            ADD_FAILURE() << path;
        } catch (const CannotRead& error) {
            EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
        }
    }
}

/// The record file exists, so that only the refusal keeps it from being read.
TEST_F(SpecialFiles, ASceneThatContainsItsRecordsReadsNoFile) {
    test::putContent(at("record.csv"), "time_s,a\n0,0\n1,2\n");
    const std::string text = R"({"format": "keyblock-scene", "version": 1, "stages": [{"kind": "dynamic", "duration": 1,
        "base_acceleration": {"direction": 0, "file": "record.csv"}}]})";
    const auto fault = [&](const RecordFolder& folder) {
        for (const Problem& problem : readSceneText(text, "scene", {}, folder).problems)
            if (problem.severity == Severity::Error && problem.pointer.ends_with("/file")) return problem.message;
        return std::string();
    };
    EXPECT_EQ(fault(folder_.path()), "");
    EXPECT_NE(fault(std::nullopt).find("run store"), std::string::npos);
}

}  // namespace
}  // namespace keyblock
