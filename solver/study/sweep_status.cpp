// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/sweep_status.h"

#include "solver/files/read_error.h"
#include "solver/study/case_brief.h"
#include "solver/study/folder_lock.h"

#include <algorithm>
#include <charconv>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

long numberOfFolder(const fs::path& folder) {
    const std::string name = folder.filename().string();
    long number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    return error == std::errc() && end == name.data() + name.size() ? number : 0;
}

/// What is known of a finished case; none if it has not finished. \throws CannotRead if its summary is damaged
std::optional<CaseBrief> briefOf(const Sweep& sweep, long number, std::size_t quantities) {
    const fs::path path = summaryPath(sweep.folder, number);
    if (auto brief = readCaseBrief(path, sweep.plan.hash)) return brief;
    const std::optional<SweepCaseResult> whole = readCaseResult(path, sweep.plan.hash, quantities);
    return whole ? std::optional(CaseBrief{whole->outcome, whole->fails, whole->cpuSeconds}) : std::nullopt;
}

}  // namespace

std::vector<long> begunCases(const fs::path& sweep) {
    std::vector<long> numbers;
    std::error_code error;
    for (fs::directory_iterator group(sweep / sweepRunsName, error), end; !error && group != end;
         group.increment(error))
        for (fs::directory_iterator entry(group->path(), error); !error && entry != end; entry.increment(error))
            if (const long number = numberOfFolder(entry->path()); number > 0) numbers.push_back(number);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

SweepStatus statusOf(const Sweep& sweep, std::size_t quantities) {
    SweepStatus status;
    status.cases = sweep.plan.cases;
    status.hasCriterion = !sweep.study.fails.empty();
    for (const long number : begunCases(sweep.folder)) {
        std::optional<CaseBrief> brief;
        try {
            brief = briefOf(sweep, number, quantities);
        } catch (const CannotRead& error) {
            status.damaged.emplace_back(error.what());
            continue;
        }
        if (!brief) {
            ++(FolderLock(caseFolder(sweep.folder, number)).isHeld() ? status.interrupted : status.running);
            continue;
        }
        ++status.finished;
        ++status.outcomes[static_cast<std::size_t>(brief->outcome)];
        status.cpuSeconds += brief->cpuSeconds;
        if (!status.hasCriterion) continue;
        if (!brief->fails) ++status.undecided;
        else if (*brief->fails) ++status.fails;
    }
    return status;
}

}  // namespace keyblock
