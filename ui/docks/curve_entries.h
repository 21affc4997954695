// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The charts offered in the dock of curves: those of the run, any quantity against any
// other, pinned points, and the curves of a second run for comparison.
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
    std::vector<double> x, y;  // against another quantity: one value per row of the history, or per frame
    bool ofFrames = false;
};

struct CurveEntries {
    std::vector<CurveEntry> entries;
    QString problem;  // why there are none
};

/// What to read from a run, and from a second run that is compared with it.
struct CurveOrder {
    std::shared_ptr<const RunSource> run, other;  // other: null if none
    CurveKind kind = CurveKind::All;
    std::vector<std::shared_ptr<const PinTrack>> tracks;
    std::string y, x;  // axes, named as in `allSeries`; without y no such curve is read
};

/// The result of reading.
struct CurveReading {
    CurveEntries own, other;  // own includes the pins
    CurveEntries free, otherFree;  // against the chosen axes
    std::string y, x;  // the chosen axes
    RunTime time;
};

/// Takes longer with every row of the history. Does not throw: the entries hold the error message.
CurveReading readCurves(const CurveOrder& order);

/// The charts of the run itself.
CurveEntries curveEntries(const RunSource& run, CurveKind kind);

/// A quantity of the run against another, named as in `allSeries`; against time if `x` is empty.
CurveEntries curveOver(const RunSource& run, const std::string& y, const std::string& x);

/// Name of the chart that holds a pin's curve, if it is among the first four.
QString pinEntryName(const Pin& pin);

/// Charts of pins, one per quantity.
std::vector<CurveEntry> pinEntries(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks);

/// Adds the curves of the same chart of another run, dashed and named `name`, to those that exist.
void addOther(CurveEntry& shown, const CurveEntry& other, const QString& name);

}  // namespace keyblock
