// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One small drift in jointed rock that is settled, excavated and bolted, and what a
// patch makes of it: odd scenes differ from it by a line, so that a row of a table
// says all that is odd about one.
#pragma once

#include "solver/files/scene/scene_file.h"
#include "solver/results/results.h"

#include <ostream>
#include <string>
#include <string_view>

namespace keyblock::test {

/// The drift after a merge patch (RFC 7396): keys of the patch take the place of the drift's, null removes one.
SceneReading oddScene(std::string_view patch);

/// What was read, and what running it left; nothing where it was refused.
struct OddRun {
    SceneReading reading;
    Results results;

    const Scene& solved() const { return reading.cut ? reading.cut->scene : *reading.scene; }
};

OddRun runOddScene(std::string_view patch);

/// A row of a table of scenes that run.
struct Odd {
    const char* name;
    const char* patch;
    const char* ends;  // a letter a stage: equilibrium, duration, collapse
    double area;  // of the blocks at the start [m²]
    void (*holds)(const OddRun&);  // what else does; null: what holds for all
};

void PrintTo(const Odd& scene, std::ostream* out);

/// What holds for all: no rock is lost in the cut, everything is counted, the stages end as they must, with finite
/// numbers and energy that adds up; then the row's own.
void expectRuns(const Odd& scene);

/// Same blocks and displacements as of the drift itself, to a thousandth of its largest.
void asPlain(const OddRun& run);

void nothingMoves(const OddRun& run);

/// The last stage changes nothing any more.
void lastIsIdle(const OddRun& run);

inline constexpr double domainArea = 48.0;  // [m²]
inline constexpr double tunnelArea = 3.12144515225805;  // of the polygon of 32 edges: 16·sin(2π/32) [m²]

/// All problems of a reading, a line each.
std::string listing(const SceneReading& reading);

/// True where a warning has the word in its message or remedy.
bool warns(const SceneReading& reading, std::string_view word);

/// True where the cut tells of one.
bool notes(const SceneReading& reading, CutNoteKind kind);

/// Largest displacement of a block that is there, in a frame [m].
double largestMove(const Frame& frame);

/// The last frame of a stage. \pre the stage has one.
const Frame& endOf(const Results& results, int stage);

}  // namespace keyblock::test
