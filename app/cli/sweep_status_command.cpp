// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `sweep status`.
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "solver/scene/number_text.h"
#include "solver/scene/visible_text.h"
#include "solver/study/case_result.h"
#include "solver/study/case_run.h"
#include "solver/study/sweep_status.h"

#include <nlohmann/json.hpp>

namespace keyblock::cli {

namespace {

std::string statusJson(const SweepStatus& status) {
    nlohmann::ordered_json outcomes = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < status.outcomes.size(); ++i)
        outcomes[std::string(wordOf(static_cast<CaseOutcome>(i)))] = status.outcomes[i];
    nlohmann::ordered_json json{{"cases", status.cases},
                                {"finished", status.finished},
                                {"running", status.running},
                                {"interrupted", status.interrupted},
                                {"waiting", status.waiting()},
                                {"outcomes", outcomes},
                                {"damaged", status.damaged.size()},
                                {"cpu_s", status.cpuSeconds}};
    if (status.hasCriterion) json.update({{"fails", status.fails}, {"undecided", status.undecided}});
    return json.dump() + "\n";
}

std::string statusText(const SweepStatus& status) {
    std::string text = std::to_string(status.finished) + " of " + std::to_string(status.cases) + " cases finished, " +
                       std::to_string(status.running) + " running, " + std::to_string(status.interrupted) +
                       " interrupted, " + std::to_string(status.waiting()) + " waiting\n";
    for (std::size_t i = 1; i < status.outcomes.size(); ++i)
        if (status.outcomes[i] > 0)
            text += std::to_string(status.outcomes[i]) + " " + std::string(wordOf(static_cast<CaseOutcome>(i))) + "\n";
    if (status.hasCriterion) text += std::to_string(status.fails) + " fail\n";
    if (status.undecided > 0) text += std::to_string(status.undecided) + " without a decision on failure\n";
    if (status.finished > 0)
        text += "processor time: " + rounded(status.cpuSeconds) + " s, " +
                rounded(status.cpuSeconds / static_cast<double>(status.finished)) + " s for each case\n";
    return text;
}

}  // namespace

ExitCode perform(const SweepStatusOptions& options) {
    const Sweep sweep = openSweep(options.sweep);
    const SweepStatus status = statusOf(sweep, sweepRunOf(sweep, 1).quantities.size());
    print(options.json ? statusJson(status) : statusText(status));
    for (const std::string& damaged : status.damaged) printErrorLine(damaged);
    return Done;
}

}  // namespace keyblock::cli
