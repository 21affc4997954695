// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The charts offered in the Curves dock: those of the run, any quantity against any
// other, pinned points, and the curves of a second run for comparison.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/charts/pins.h"
#include "ui/picture/run_time.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace keyblock {

enum class CurveKind { All, Energies };

/// A chart with one panel, and all values of its first curve. A `ChartView` may draw fewer points of the curve.
struct CurveEntry {
    QString name;
    Chart chart;
    std::vector<double> x, y;  // values of a curve against another quantity: one per history row, or per frame
    bool ofFrames = false;
};

struct CurveEntries {
    std::vector<CurveEntry> entries;
    QString problem;  // error message if there are no entries
};

/// Curves to read from a run, and from a second run for comparison.
struct CurveOrder {
    std::shared_ptr<const RunSource> run, other;  // other: null if there is no second run
    CurveKind kind = CurveKind::All;
    std::vector<std::shared_ptr<const PinTrack>> tracks;
    std::string y, x;  // names of the quantities, as in `allSeries`; empty y: no such curve is read
};

/// The curves read for a `CurveOrder`.
struct CurveReading {
    CurveEntries own, other;  // entries of the run, including its pins, and of the second run
    CurveEntries free, otherFree;  // curves of the chosen quantities
    std::string y, x;  // names of the chosen quantities
    RunTime time;
};

/// Reads the curves of an order. The time needed grows with the number of history rows. Does not throw: errors are
/// reported in `CurveEntries::problem`.
CurveReading readCurves(const CurveOrder& order);

/// The charts of the run itself, without pins.
CurveEntries curveEntries(const RunSource& run, CurveKind kind);

/// Plots the quantity `y` of the run against `x`, or against time if `x` is empty. Both names are as in `allSeries`.
CurveEntries curveOver(const RunSource& run, const std::string& y, const std::string& x);

/// Name of the first chart with the quantity of this pin. There can be several charts, because each shows at most four
/// pins.
QString pinEntryName(const Pin& pin);

/// Charts of the pins, grouped by quantity. A chart shows at most four pins.
std::vector<CurveEntry> pinEntries(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks);

/// Adds the curves of `other`, a chart of the same quantity from another run, as dashed lines. `name` identifies the
/// other run in a note on the chart.
void addOther(CurveEntry& shown, const CurveEntry& other, const QString& name);

}  // namespace keyblock
