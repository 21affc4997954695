// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A store with the usual extension is not opened: closing a file releases the locks
// that this process holds on it, and the store may be one that it is writing.
#include "solver/files/kept_files.h"

#include "solver/run/write_error.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestStart = std::size_t{64} << 10;  // bytes read to recognise a file

std::string startOf(const fs::path& path) {
    std::string start(longestStart, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return start;
}

bool isScene(const fs::path& path, const std::string& start) {
    const std::size_t first = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    const bool isObject = first != std::string::npos && start[first] == '{';
    return isObject && (path.extension() == ".json" || start.find("\"keyblock-scene\"") != std::string::npos);
}

}  // namespace

std::string whyKept(const fs::path& path, std::span<const fs::path> sources, Scenes scenes) {
    std::error_code error;
    if (!fs::exists(path, error)) return {};
    const std::string shown = "'" + path.string() + "'";
    for (const fs::path& source : sources)
        if (fs::equivalent(path, source, error)) return shown + " is the file that is read";
    if (!fs::is_regular_file(path, error) || fs::file_size(path, error) == 0) return {};
    if (path.extension() == ".kbrun") return shown + " is a run store";
    const std::string start = startOf(path);
    if (start.starts_with("SQLite format 3")) return shown + " is a run store or another database";
    return scenes == Scenes::Kept && isScene(path, start) ? shown + " is a scene" : "";
}

void requireReplaceable(const fs::path& path, std::span<const fs::path> sources, Scenes scenes) {
    if (const std::string why = whyKept(path, sources, scenes); !why.empty())
        throw CannotWrite("cannot write " + path.string() + ": " + why + "; choose another name");
}

}  // namespace keyblock
