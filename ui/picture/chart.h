// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts as plain values: panels one below the other on one axis of abscissas,
// each with curves, limits and its own range. Paper and screen draw the same.
#pragma once

#include "ui/picture/ticks.h"

#include <functional>
#include <string>
#include <vector>

namespace keyblock {

inline constexpr int mostPanelTicks = 5;
inline constexpr double limitReach = 1.5;  // a limit is shown that is no farther out than this times the largest value

enum class CurveStyle {
    Main,
    Second,
    Third,
    Fourth,
    Envelope,
    Stems,
    Reference,  // measured or published by others, as the three below; named in a key above the panel
    SecondReference,
    ThirdReference,
    FourthReference
};

inline bool isReference(CurveStyle style) { return style >= CurveStyle::Reference; }

struct ChartCurve {
    std::string name;  // written at its right end; empty: not
    CurveStyle style = CurveStyle::Main;
    std::vector<double> x, y;  // as shown
    int table = -1;  // of a reference: its number
    std::string column{};  // of a reference
    bool ofOther = false;  // of the run that is compared: drawn broken
};

struct ChartLimit {
    std::string name;
    double value = 0.0;  // the farthest from zero
    bool ultimate = false;
    std::vector<double> x{}, y{};  // where it runs; empty: at its value all along
};

struct ChartPanel {
    std::string title;  // with its unit
    std::string note;  // on signs, after the title
    std::vector<ChartCurve> curves;
    std::vector<ChartLimit> limits;
    ValueRange reached{0.0, 0.0};  // until now, by what the curves show: their range holds it
    ValueRange range;
};

/// A stretch of abscissas with a meaning: a slipping zone, a stage.
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

    /// Abscissas are places on an axis on which each stage has its own time; else they are what the title says.
    bool isStaged() const { return stages.size() > 1; }
};

/// A number on an axis.
struct AxisTick {
    double at = 0.0;  // on the axis
    std::string text;
};

/// Round times of each stage, as many as have room: `perUnit` is the length of one on the axis, `widthOf` that of a text
/// with the gap beside it.
std::vector<AxisTick> stageTicks(const std::vector<StageSpan>& stages, double perUnit,
                                 const std::function<double(const std::string&)>& widthOf);

/// A moment in a stage's own time.
struct StageMoment {
    const StageSpan* span;
    double time = 0.0;
};

/// The moment at a place of the axis, the nearest end beyond it. \pre there are stages.
StageMoment momentAt(const std::vector<StageSpan>& stages, double place);

/// Sets the panel's range from its curves and what was reached, with zero, and with limits that lie within 1.5 times of what is reached;
/// limits beyond go. A panel of nothing but zeros has the range 0 … 1.
void fitRange(ChartPanel& panel);

/// The curve by at most about `most` points: of each run of points the first, the last, the least and the largest stay,
/// in their order, so that no peak goes.
ChartCurve thinned(const ChartCurve& curve, std::size_t most);

}  // namespace keyblock
