// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The remaining time is extrapolated from the fraction that is done. It is not shown
// before that fraction is large enough for an estimate.
#include "app/cli/progress.h"

#include "app/cli/output.h"
#include "app/cli/text_table.h"
#include "solver/results/run_source.h"
#include "solver/results/result_names.h"
#include "solver/scene/collapse_stage.h"
#include "solver/scene/solved_blocks.h"
#include "solver/scene/visible_text.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace keyblock::cli {

namespace {

constexpr std::chrono::milliseconds shortestPause{100};
constexpr double leastFraction = 0.005;  // smallest fraction for which the remaining time is estimated
constexpr int barCells = 24;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::optional<double> secondsLeft(double elapsed, double start, double fraction) {
    if (fraction - start < leastFraction)
        return std::nullopt;
    const double seconds = elapsed * (1.0 - std::min(fraction, 1.0)) / (fraction - start);
    return std::round(1000.0 * seconds) / 1000.0;
}

std::string twoDigits(long value) { return (value < 10 ? "0" : "") + std::to_string(value); }

/// A duration as `m:ss`, or `h:mm:ss`.
std::string clockText(double seconds) {
    constexpr double longest = 3600.0 * 999.0;
    const long whole = std::lround(std::min(seconds, longest));
    const long hours = whole / 3600;
    const long minutes = whole / 60 % 60;
    const std::string start = hours > 0 ? std::to_string(hours) + ":" + twoDigits(minutes) : std::to_string(minutes);
    return start + ":" + twoDigits(whole % 60);
}

/// The first `width` characters of a UTF-8 text.
std::string cutTo(const std::string& text, std::size_t width) {
    std::size_t end = text.size();
    while (shownWidth(text.substr(0, end)) > width)
        --end;
    while (end < text.size() && shownWidth(text.substr(end, 1)) == 0)
        ++end;
    return text.substr(0, end);
}

std::string eventText(const Scene& scene, const Event& event) {
    std::string text = std::string(rowOf(event.kind).title);
    if (event.bolt >= 0)
        text += " of " + boltName(scene, event.bolt);
    if (event.node >= 0)
        text += " at node " + std::to_string(event.node);
    if (event.element >= 0)
        text += " in element " + std::to_string(event.element);
    return text;
}

}  // namespace

ProgressKind chosenProgress(ProgressKind kind) {
    if (kind != ProgressKind::Automatic)
        return kind;
    return errorIsTerminal() ? ProgressKind::Bar : ProgressKind::None;
}

ProgressSink::ProgressSink(const Scene& scene, Sink& next, ProgressKind kind, std::string label)
    : scene_(withCollapseStages(scene)),
      blocks_(blockNames(scene)),
      next_(next),
      kind_(kind),
      label_(std::move(label)),
      runStart_(Clock::now()),
      stageStart_(runStart_) {
    assert(kind != ProgressKind::Automatic);
}

void ProgressSink::begin(const Scene& scene, const HistoryColumns& columns) {
    runStart_ = Clock::now();
    startFraction_ = 0.0;
    next_.begin(scene, columns);
}

void ProgressSink::resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from) {
    stageStart_ = runStart_ = Clock::now();
    startFraction_.reset();
    next_.resume(scene, columns, from);
}

void ProgressSink::stageBegins(int stage) {
    stageStart_ = Clock::now();
    next_.stageBegins(stage);
}

void ProgressSink::event(const Event& event) {
    lastEvent_ = event;
    next_.event(event);
}

void ProgressSink::stageEnds(const StageResult& result) {
    stageSeconds_[result.stage] = secondsSince(stageStart_);
    progress_.stage = result.stage;
    progress_.time = result.time;
    if (endsRun(scene_, result))
        progress_.fraction = 1.0;
    unreported_ = true;
    next_.stageEnds(result);
}

void ProgressSink::update(const Progress& progress) {
    progress_ = progress;
    if (!startFraction_)
        startFraction_ = progress.fraction;
    unreported_ = true;
    if (kind_ == ProgressKind::None || (lastReport_ && Clock::now() - *lastReport_ < shortestPause))
        return;
    tell();
}

ProgressSink::~ProgressSink() {
    if (kind_ == ProgressKind::Json && unreported_)
        tell();
    if (kind_ == ProgressKind::Bar) replaceErrorLine("");
}

void ProgressSink::tell() {
    lastReport_ = Clock::now();
    unreported_ = false;
    const ProgressLine line{label_ + stageName(scene_, progress_.stage),
                            progress_.time,
                            progress_.fraction,
                            secondsLeft(secondsSince(runStart_), startFraction_.value_or(0.0), progress_.fraction),
                            progress_.passes,
                            progress_.events,
                            searchText(progress_.step, blocks_)};
    if (kind_ == ProgressKind::Json) printToError(progressJson(line));
    else replaceErrorLine(barText(line));
}

std::string ProgressSink::barText(const ProgressLine& line) const {
    const double fraction = std::clamp(line.fraction, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(std::floor(fraction * barCells));
    std::string text = line.stage + " [" + std::string(filled, '#') + std::string(barCells - filled, '-') + "] " +
                       std::to_string(std::lround(std::floor(100.0 * fraction))) + " %";
    if (!line.search.empty())
        text += "  " + line.search;
    else if (line.secondsLeft)
        text += "  " + clockText(*line.secondsLeft) + " left";
    text += "  " + std::to_string(line.events) + (line.events == 1 ? " event" : " events");
    if (lastEvent_)
        text += ", last " + eventText(scene_, *lastEvent_);
    return cutTo(visibleText(text), static_cast<std::size_t>(terminalWidth() - 1));
}

}  // namespace keyblock::cli
