// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts as plain values: panels one below the other that share the horizontal axis,
// each with curves, limits and its own vertical range. Figures and the window draw
// charts from the same data.
#pragma once

#include "solver/scene/bolt_quantities.h"
#include "ui/picture/ticks.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

inline constexpr int mostPanelTicks = 5;
inline constexpr double limitReach = 1.5;  // limits up to this multiple of the largest value are shown

enum class CurveStyle {
    Main,
    Second,
    Third,
    Fourth,
    Envelope,
    Stems,
    Reference,  // this and the next three: measured or published data, named in a key above the panel
    SecondReference,
    ThirdReference,
    FourthReference
};

inline bool isReference(CurveStyle style) { return style >= CurveStyle::Reference; }

struct ChartCurve {
    std::string name;  // label at the right end of the curve; empty: no label
    CurveStyle style = CurveStyle::Main;
    std::vector<double> x, y;  // in the units of the axes
    int table = -1;  // index of the reference table; −1: not a reference curve
    std::string column{};  // name of the column, for a reference curve
    bool ofOther = false;  // belongs to the run that is compared: drawn dashed
};

struct ChartLimit {
    std::string name;
    double value = 0.0;  // for a limit that varies: its value of largest magnitude
    bool ultimate = false;
    std::vector<double> x{}, y{};  // course of a limit that varies along the axis; empty: constant
};

struct ChartPanel {
    std::string title;  // with its unit
    std::string note;  // sign convention, after the title
    std::vector<ChartCurve> curves;
    std::vector<ChartLimit> limits;
    ValueRange reached{0.0, 0.0};  // range of values to date; `range` always includes it
    ValueRange range;
    std::optional<BoltQuantity> bolts;  // the quantity shown, if the panel is part of a bolt diagram
};

/// A shaded interval of the horizontal axis, such as a slipping zone.
struct ChartZone {
    double from = 0.0, to = 0.0;
};

/// Interval of a time axis that one stage occupies.
struct StageSpan {
    int stage = 0;
    std::string name;
    double from = 0.0, to = 0.0;  // positions on the axis
    double reached = 0.0;  // time at `to`, counted from the start of the stage: [s], or pseudo-time
};

struct Chart {
    std::string xTitle;  // with its unit
    ValueRange x;
    bool overTime = false;
    std::vector<StageSpan> stages{};  // for a time axis
    std::vector<ChartPanel> panels;
    std::vector<ChartZone> zones;  // shaded through all panels
    std::vector<double> dividers;  // dotted vertical lines through all panels
    std::vector<double> events;  // faint vertical lines through all panels, with a tick on the axis

    /// True if the axis shows several stages. Each stage then has its own time, and positions on the axis are not
    /// times.
    bool isStaged() const { return stages.size() > 1; }
};

/// A labelled tick of an axis.
struct AxisTick {
    double at = 0.0;  // position on the axis
    std::string text;
};

/// Ticks at round times of each stage, as many as fit without overlapping labels.
/// \param perUnit length of one axis unit in the drawing.
/// \param widthOf returns the width of a label plus the gap to the next label, in the same unit of length.
std::vector<AxisTick> stageTicks(const std::vector<StageSpan>& stages, double perUnit,
                                 const std::function<double(const std::string&)>& widthOf);

/// A time, counted from the start of its stage.
struct StageMoment {
    const StageSpan* span;
    double time = 0.0;
};

/// Stage and time at the position `place` on the axis. A position beyond the axis is treated as the nearest end of the
/// axis.
/// \pre `stages` is not empty.
StageMoment momentAt(const std::vector<StageSpan>& stages, double place);

/// Sets `panel.range` so that it includes zero, `panel.reached` and all curves. The range also includes each limit that
/// is at most 1.5 times the largest of these values on the same side of zero. Limits further from zero are removed from
/// the panel. A panel that contains only zeros gets the range 0 … 1.
void fitRange(ChartPanel& panel);

/// The curve reduced to about `most` points. The points are divided into groups of consecutive points, and the first,
/// last, lowest and highest point of each group are kept, so that peaks are preserved.
ChartCurve thinned(const ChartCurve& curve, std::size_t most);

}  // namespace keyblock
