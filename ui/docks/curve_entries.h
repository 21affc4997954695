// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The charts that the dock of curves offers: those that a run has of itself, any
// number over any other, what a person pinned, and beside them those of another run.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/pins.h"
#include "ui/picture/run_time.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace keyblock {

enum class CurveKind { All, Energies };

/// A chart of one panel, with the whole first curve before it is thinned.
struct CurveEntry {
    QString name;
    Chart chart;
    std::vector<double> x, y;  // over another number: a value for each row of the history, or each frame
    bool ofFrames = false;
};

struct CurveEntries {
    std::vector<CurveEntry> entries;
    QString problem;  // why there are none
};

/// What is to be read of a run, and of another that stands beside it.
struct CurveOrder {
    std::shared_ptr<const RunSource> run, other;  // other: null where there is none
    CurveKind kind = CurveKind::All;
    std::vector<std::shared_ptr<const PinTrack>> tracks;
    std::string y, x;  // axes by the names of `allSeries`; without y no such curve is wanted
};

/// What was read.
struct CurveReading {
    CurveEntries own, other;  // pins among the own
    CurveEntries free, otherFree;  // over the axes that were asked for
    std::string y, x;  // those
    RunTime time;
};

/// Takes longer with every row of the history. Throws nothing: what is wrong is told by the entries.
CurveReading readCurves(const CurveOrder& order);

/// What a run shows of itself.
CurveEntries curveEntries(const RunSource& run, CurveKind kind);

/// A number of the run over another, by the names of `allSeries`; over time where `x` is empty.
CurveEntries curveOver(const RunSource& run, const std::string& y, const std::string& x);

/// What the chart is called that a pin's curve stands in, where it is among the first four.
QString pinEntryName(const Pin& pin);

/// Of pins, those of one quantity together.
std::vector<CurveEntry> pinEntries(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks);

/// Puts the curves of the same chart of another run beside those that are there, drawn broken, called `name`.
void addOther(CurveEntry& shown, const CurveEntry& other, const QString& name);

}  // namespace keyblock
