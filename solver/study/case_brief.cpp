// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/case_brief.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace keyblock {

namespace {

constexpr std::size_t mostBriefBytes = 16384;  // larger summaries are read in full

/// The file if it is a regular one and fits into the buffer; empty otherwise.
std::string_view shortFile(const std::filesystem::path& path, std::array<char, mostBriefBytes>& buffer) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (file < 0) return {};
    struct stat status {};
    std::size_t size = 0;
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode))
        for (ssize_t got = 1; got > 0 && size < buffer.size();
             size += static_cast<std::size_t>(std::max<ssize_t>(0, got)))
            got = ::read(file, buffer.data() + size, buffer.size() - size);
    ::close(file);
    return size < buffer.size() ? std::string_view(buffer.data(), size) : std::string_view();
}

/// The text of a member of the outermost object. It begins a line with one space; texts contain no line feeds.
std::string_view memberText(std::string_view text, std::string_view key) {
    const std::string begin = "\n \"" + std::string(key) + "\": ";
    const std::size_t at = text.find(begin);
    if (at == std::string_view::npos) return {};
    const std::size_t from = at + begin.size(), end = text.find('\n', from);
    if (end == std::string_view::npos) return {};
    return text.substr(from, end - from - (text[end - 1] == ',' ? 1 : 0));
}

std::optional<CaseOutcome> outcomeIn(std::string_view word) {
    for (int i = 0; i <= static_cast<int>(CaseOutcome::Error); ++i)
        if (word == '"' + std::string(wordOf(static_cast<CaseOutcome>(i))) + '"') return static_cast<CaseOutcome>(i);
    return std::nullopt;
}

}  // namespace

std::optional<CaseBrief> readCaseBrief(const std::filesystem::path& file, const std::string& sweep) {
    std::array<char, mostBriefBytes> buffer;
    const std::string_view text = shortFile(file, buffer);
    if (!text.starts_with("{\n") || !text.ends_with("\n}\n")) return std::nullopt;
    if (memberText(text, "sweep") != '"' + sweep + '"') return std::nullopt;
    CaseBrief brief;
    const std::optional<CaseOutcome> outcome = outcomeIn(memberText(text, "outcome"));
    const std::string_view fails = memberText(text, "fails"), cpu = memberText(text, "cpu_s");
    const auto [end, error] = std::from_chars(cpu.data(), cpu.data() + cpu.size(), brief.cpuSeconds);
    const bool isVerdict = fails == "true" || fails == "false" || fails == "null";
    if (!outcome || !isVerdict || error != std::errc() || end != cpu.data() + cpu.size()) return std::nullopt;
    brief.outcome = *outcome;
    if (fails != "null") brief.fails = fails == "true";
    return brief;
}

}  // namespace keyblock
