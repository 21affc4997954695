// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder of a test's own, gone with the test.
#pragma once

#include <filesystem>
#include <string>

namespace keyblock::test {

class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// The whole content of a file; empty when it cannot be opened.
std::string contentOf(const std::filesystem::path& file);

/// Makes or replaces a file.
void putContent(const std::filesystem::path& file, const std::string& content);

}  // namespace keyblock::test
