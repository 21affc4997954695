// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/figure/reader.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace keyblock::test {

std::optional<std::string> readBy(const std::string& program, const std::string& arguments, const std::string& bytes,
                                  const std::string& ending) {
    if (std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) != 0) return std::nullopt;
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("keyblock-figure-" + std::to_string(getpid()) + ending);
    std::ofstream(file, std::ios::binary) << bytes;
    std::string command = program + " " + arguments + " 2>/dev/null";
    command.replace(command.find('%'), 1, file.string());
    std::string text;
    std::array<char, 4096> part{};
    FILE* pipe = popen(command.c_str(), "r");
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), read);
    const int ended = pclose(pipe);
    std::filesystem::remove(file);
    if (ended != 0) return std::nullopt;
    return text;
}

}  // namespace keyblock::test
