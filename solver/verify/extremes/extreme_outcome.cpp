// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/extremes/extreme_outcome.h"

#include "solver/engine/setup/mesh_check.h"
#include "solver/results/result_names.h"
#include "solver/results/verdict.h"
#include "solver/run/run.h"
#include "solver/scene/check.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <initializer_list>

namespace keyblock {

namespace {

constexpr double mostSeconds = 8.0;  // [s] of a run, after which it counts as stopped
constexpr double energyAllowed = 0.05;  // energy balance error / largest term

void takeProblems(const std::vector<Problem>& problems, ExtremeOutcome& outcome) {
    for (const Problem& problem : problems) {
        const std::string text = problem.pointer + ": " + problem.message;
        if (problem.severity == Severity::Error && outcome.refused.empty()) outcome.refused = text;
        if (problem.severity == Severity::Warning) outcome.warnings.push_back(text);
    }
}

void takeStages(const Solved& solved, ExtremeOutcome& outcome) {
    for (const StageResult& stage : solved.results.stages) {
        if (endedAsPlanned(stage.outcome) || endedUnstable(stage.outcome) || !outcome.stopped.empty()) continue;
        outcome.stopped = std::string(wordOf(stage.outcome)) + (stage.message.empty() ? "" : ": " + stage.message);
        if (stage.message.empty() && stage.outcome == Outcome::Failed) outcome.broken = "it failed without a message";
    }
    if (solved.results.stages.empty()) outcome.broken = "no stage ended";
    for (const StageWarning& warning : stageWarnings(MemoryRun(solved.scene, solved.results)))
        outcome.warnings.push_back(warning.text);
}

bool areFinite(std::initializer_list<double> numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

bool isFiniteFrame(const Frame& frame) {
    for (const BlockState& block : frame.blocks)
        if (!block.centroid.allFinite() || !block.velocity.allFinite() || !block.displacement.allFinite() ||
            !areFinite({block.rotation, block.stress[0], block.stress[1], block.stress[2]}))
            return false;
    for (const ContactFrame& contact : frame.contacts)
        if (!areFinite({contact.normalForce, contact.shearForce, contact.penetration})) return false;
    for (const BoltFrame& bolt : frame.bolts)
        for (const BoltNodeFrame& node : bolt.nodes)
            if (!node.position.allFinite() || !areFinite({node.axialForce, node.shearForce, node.moment, node.slip}))
                return false;
    return std::isfinite(frame.energy.balanceError);
}

/// A warning that the run does not get under ordinary conditions; empty if there is none.
std::string newWarning(const std::vector<std::string>& warnings, const std::vector<std::string>& ordinary) {
    // numbers in a warning differ from run to run, so only its words are compared
    const auto words = [](std::string text) {
        std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; });
        return text;
    };
    for (const std::string& warning : warnings)
        if (std::none_of(ordinary.begin(), ordinary.end(),
                         [&](const std::string& other) { return words(other) == words(warning); }))
            return warning;
    return {};
}

}  // namespace

ExtremeOutcome runExtreme(const Scene& scene) {
    ExtremeOutcome outcome;
    try {
        std::optional<SceneCut> cut;
        takeProblems(checkScene(scene, &cut), outcome);
        if (!outcome.refused.empty()) return outcome;
        Solved solved{cut ? cut->scene : scene, {}};
        takeProblems(checkMeshes(solved.scene), outcome);
        Scene limited = scene;
        limited.limits.wallTime = mostSeconds;
        RunSettings settings;
        settings.threads = 1;
        if (cut) cut->scene.limits.wallTime = mostSeconds;
        if (cut) settings.cut = &*cut;
        solved.results = runInMemory(limited, settings);
        takeStages(solved, outcome);
        outcome.solved = std::move(solved);
    } catch (const std::exception& error) {
        outcome.broken = error.what();
    }
    return outcome;
}

void judgeNumbers(const Solved& solved, Findings& findings) {
    const std::vector<Frame>& frames = solved.results.frames;
    findings.holds("every number is finite",
                   !frames.empty() && std::all_of(frames.begin(), frames.end(), isFiniteFrame));
    if (!frames.empty()) findings.holds("the kinetic energy is not negative", frames.back().energy.kinetic >= 0.0);
}

void judgeEnergy(const Solved& solved, Findings& findings) {
    if (solved.scene.stages.front().kind == StageKind::Dynamic)
        findings.atMost("energy balance error", std::abs(solved.results.stages.back().health.balanceError), 0.0,
                        energyAllowed);
}

ExtremeRun judged(const ExtremeOutcome& outcome, const Findings& findings, const std::vector<std::string>& ordinary) {
    ExtremeRun run;
    if (!findings.isEmpty()) {
        const Finding& worst = findings.worst();
        run.quantity = worst.quantity;
        run.measured = worst.measured;
        run.expected = worst.expected;
        run.tolerance = worst.tolerance;
    }
    if (!outcome.broken.empty()) {
        run.reason = outcome.broken;
        return run;
    }
    if (!outcome.refused.empty() || !outcome.stopped.empty()) {
        run.ending = outcome.refused.empty() ? ExtremeEnding::Stopped : ExtremeEnding::Refused;
        run.reason = outcome.refused.empty() ? outcome.stopped : outcome.refused;
        return run;
    }
    if (findings.allRight()) {
        run.ending = ExtremeEnding::Right;
        return run;
    }
    run.reason = newWarning(outcome.warnings, ordinary);
    if (!run.reason.empty()) run.ending = ExtremeEnding::Warned;
    else run.reason = "no warning";
    return run;
}

}  // namespace keyblock
