// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts as plain values: panels one below the other on one axis of abscissas, each
// with curves, limits and its own range. Paper and screen draw the same.
#pragma once

#include "solver/scene/bolt_quantities.h"
#include "ui/picture/ticks.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

inline constexpr int mostPanelTicks = 5;
inline constexpr double limitReach = 1.5;  // limits up to this factor times the largest value are shown

enum class CurveStyle {
    Main,
    Second,
    Third,
    Fourth,
    Envelope,
    Stems,
    Reference,  // measured or published data, as the three below; named in a key above the panel
    SecondReference,
    ThirdReference,
    FourthReference
};

inline bool isReference(CurveStyle style) { return style >= CurveStyle::Reference; }

struct ChartCurve {
    std::string name;  // written at its right end; empty: none
    CurveStyle style = CurveStyle::Main;
    std::vector<double> x, y;  // as shown
    int table = -1;  // of a reference: its number
    std::string column{};  // of a reference
    bool ofOther = false;  // of the compared run: dashed
};

struct ChartLimit {
    std::string name;
    double value = 0.0;  // the farthest from zero
    bool ultimate = false;
    std::vector<double> x{}, y{};  // abscissas of a limit that varies; empty: constant
};

struct ChartPanel {
    std::string title;  // with its unit
    std::string note;  // sign convention, after the title
    std::vector<ChartCurve> curves;
    std::vector<ChartLimit> limits;
    ValueRange reached{0.0, 0.0};  // values so far of the quantities shown: included in their range
    ValueRange range;
    std::optional<BoltQuantity> bolts;  // the quantity, of a panel along a bolt
};

/// An interval of abscissas with a meaning: a slipping zone, a stage.
struct ChartZone {
    double from = 0.0, to = 0.0;
};

/// A stage on an axis of time.
struct StageSpan {
    int stage = 0;
    std::string name;
    double from = 0.0, to = 0.0;  // on the axis
    double reached = 0.0;  // its own time at `to`: [s], or pseudo-time
};

struct Chart {
    std::string xTitle;  // with its unit
    ValueRange x;
    bool overTime = false;
    std::vector<StageSpan> stages{};  // of an axis of time
    std::vector<ChartPanel> panels;
    std::vector<ChartZone> zones;  // tinted through all panels
    std::vector<double> dividers;  // dotted through all panels
    std::vector<double> events;  // faint lines through all panels, a tick on the axis

    /// Abscissas are positions on an axis on which each stage has its own time; else they are values of the title's
    /// quantity.
    bool isStaged() const { return stages.size() > 1; }
};

/// A number on an axis.
struct AxisTick {
    double at = 0.0;  // on the axis
    std::string text;
};

/// Round times of each stage, as many as fit: `perUnit` is the length of one on the axis, `widthOf` that of a text
/// including its gap.
std::vector<AxisTick> stageTicks(const std::vector<StageSpan>& stages, double perUnit,
                                 const std::function<double(const std::string&)>& widthOf);

/// A time in a stage's own time.
struct StageMoment {
    const StageSpan* span;
    double time = 0.0;
};

/// The time at a position of the axis, beyond it the nearest end. \pre there are stages.
StageMoment momentAt(const std::vector<StageSpan>& stages, double place);

/// Sets the panel's range from its curves and the values so far, with zero, and with limits up to 1.5 times of these;
/// limits beyond are removed. A panel with only zeros has the range 0 … 1.
void fitRange(ChartPanel& panel);

/// The curve with about `most` points or fewer: of each run of points the first, last, smallest and largest stay, in
/// order, so that peaks are kept.
ChartCurve thinned(const ChartCurve& curve, std::size_t most);

}  // namespace keyblock
