// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/text_file.h"

#include "solver/files/read_error.h"
#include "solver/files/regular_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t megabyte = std::uint64_t{1} << 20;

[[noreturn]] void refuseFile(const fs::path& path, const std::string& why, const std::string& remedy) {
    throw CannotRead("cannot read " + path.string() + ": " + why + "; " + remedy);
}

void requireRegularFile(const fs::path& path, const std::string& remedy) {
    if (const std::string special = specialFileAt(path); !special.empty()) refuseFile(path, "it is " + special, remedy);
}

}  // namespace

std::string readTextFile(const fs::path& path, const TextFileLimits& limits) {
    requireRegularFile(path, limits.whatToGive);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) refuseFile(path, std::strerror(errno != 0 ? errno : EIO), limits.whatToGive);
    std::string text;
    std::array<char, 65536> part{};
    while (text.size() <= limits.bytes && (file.read(part.data(), part.size()) || file.gcount() > 0))
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > limits.bytes)
        refuseFile(path, "it is larger than " + std::to_string(limits.bytes / megabyte) + " MB", limits.ifTooLong);
    return text;
}

}  // namespace keyblock
