// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cases: every known scene along every axis that applies to it, and random
// combinations of all of its axes.
#include "solver/verify/extremes/extremes.h"

#include "geometry/random.h"
#include "solver/verify/extremes/extreme_axes.h"
#include "solver/verify/extremes/extreme_outcome.h"
#include "solver/verify/extremes/known_scenes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <map>
#include <numeric>

namespace keyblock {

namespace {

const std::vector<KnownScene>& knownScenes() {
    static const std::vector<KnownScene> all = [] {
        std::vector<KnownScene> scenes;
        for (const auto& group : {restingScenes(), movingScenes(), boltedScenes(), dividedScenes()})
            scenes.insert(scenes.end(), group.begin(), group.end());
        return scenes;
    }();
    return all;
}

/// Warnings that a scene gets under its ordinary conditions.
const std::vector<std::string>& ordinaryWarnings(const KnownScene& known) {
    static std::map<std::string, std::vector<std::string>> found;
    const auto at = found.find(known.name);
    if (at != found.end()) return at->second;
    return found[known.name] = runExtreme(placed(known.usual, known.scene(known.usual))).warnings;
}

ExtremeRun runKnown(const KnownScene& known, const Conditions& conditions) {
    const std::vector<std::string>& ordinary = ordinaryWarnings(known);
    const auto start = std::chrono::steady_clock::now();
    ExtremeOutcome outcome = runExtreme(placed(conditions, known.scene(conditions)));
    Findings findings;
    if (outcome.solved && outcome.broken.empty()) {
        judgeNumbers(*outcome.solved, findings);
        if (outcome.stopped.empty()) {
            judgeEnergy(*outcome.solved, findings);
            known.judge(conditions, *outcome.solved, findings);
        } else if (!findings.allRight()) outcome.broken = "it stopped with invalid results: " + outcome.stopped;
    }
    ExtremeRun run = judged(outcome, findings, ordinary);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return run;
}

ExtremeRun runOnAxis(const KnownScene& known, const ExtremeAxis& axis, double value) {
    Conditions conditions = known.usual;
    axis.apply(conditions, value);
    ExtremeRun run = runKnown(known, conditions);
    run.value = valueText(axis, value);
    run.usual = value == axis.usual(known.usual);
    return run;
}

ExtremeCase caseOf(const KnownScene& known, const ExtremeAxis& axis) {
    ExtremeCase made;
    made.name = known.name + "/" + axis.name;
    made.scene = known.shows;
    made.axis = axis.title;
    made.property = known.property;
    made.reason = axis.reason;
    made.values = axis.values;
    made.isChoice = !axis.words.empty();
    made.run = [&known, &axis](std::size_t index) { return runOnAxis(known, axis, axis.values.at(index)); };
    return made;
}

double drawn(const ExtremeAxis& axis, double share) {
    if (!axis.logarithmic) return axis.least + share * (axis.most - axis.least);
    return axis.least * std::pow(axis.most / axis.least, share);
}

/// Each axis is pushed with a probability of two fifths.
constexpr double pushed = 0.4;

}  // namespace

std::string_view wordOf(ExtremeEnding ending) {
    constexpr std::array<std::string_view, extremeEndings> words{"right", "warned", "refused", "stopped", "wrong"};
    return words[static_cast<std::size_t>(ending)];
}

const std::vector<ExtremeCase>& extremeCases() {
    static const std::vector<ExtremeCase> all = [] {
        std::vector<ExtremeCase> made;
        for (const KnownScene& known : knownScenes())
            for (const std::string& axis : known.axes) made.push_back(caseOf(known, extremeAxis(axis)));
        return made;
    }();
    return all;
}

int ExtremeCounts::all() const { return std::accumulate(endings.begin(), endings.end(), 0); }

ExtremeCounts countsOf(const std::vector<ExtremeRun>& runs) {
    ExtremeCounts counts;
    std::vector<double> seconds;
    for (const ExtremeRun& run : runs) {
        ++counts.endings[static_cast<std::size_t>(run.ending)];
        seconds.push_back(run.seconds);
    }
    std::sort(seconds.begin(), seconds.end());
    if (!seconds.empty()) {
        counts.median = seconds[seconds.size() / 2];
        counts.longest = seconds.back();
    }
    return counts;
}

ExtremeRun randomExtreme(std::uint64_t seed, int number) {
    for (std::int64_t attempt = 0;; ++attempt) {
        Random random(seed, {number, attempt});
        const std::vector<KnownScene>& scenes = knownScenes();
        const KnownScene& known =
            scenes[static_cast<std::size_t>(random.uniform() * static_cast<double>(scenes.size()))];
        Conditions conditions = known.usual;
        std::string text = known.name;
        for (const std::string& name : known.axes) {
            const ExtremeAxis& axis = extremeAxis(name);
            if (random.uniform() > pushed) continue;
            const double value = drawn(axis, random.uniform());
            axis.apply(conditions, value);
            text += ", " + name + " " + valueText(axis, value);
        }
        if (known.applies && !known.applies(conditions)) continue;
        ExtremeRun run = runKnown(known, conditions);
        run.value = text;
        return run;
    }
}

}  // namespace keyblock
