// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures for a report, painted without a screen: the one door to Qt for whoever
// wants a picture of a run on paper. Nothing of Qt shows here.
#pragma once

#include "geometry/polygon.h"
#include "solver/results/reference_table.h"
#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"
#include "solver/scene/problem.h"
#include "ui/picture/scale_choice.h"

#include <functional>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

enum class FigureKind { Section, Bolt, Curves, Events };
enum class PaperFormat { Svg, Pdf, Png };

/// In place of a quantity of a section: blocks or bolts are not coloured.
inline constexpr std::string_view plainWord = "plain";

struct FigureRequest {
    FigureKind kind = FigureKind::Section;
    PaperFormat format = PaperFormat::Svg;
    TableFilter filter;  // moment and bolt
    std::optional<std::string> quantity;
    double width = 160.0;  // [mm]
    int dpi = 300;  // of PNG
    double factor = 1.0;  // displacements are drawn enlarged by it
    bool whole = false;  // the whole model, not what surrounds tunnels and bolts
    ScaleChoices scales{};  // of the colours of a section
    std::optional<Box> window;  // of a section [m]; null: as `whole` says
    std::optional<std::string> boltQuantity;  // of a section; null: as `quantity` says, else the axial force
    std::string title;  // empty: the figure's own
    std::vector<ReferenceTable> references{};  // beside the curves
    std::string runName;  // for the foot of the figure
};

/// What was asked for cannot be drawn of this run; says what to ask for instead.
struct CannotDraw : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A table of what the figure shows.
struct FigureData {
    std::string suffix;  // of the file's name, before .csv
    std::function<void(std::ostream&)> write;
};

struct Figure {
    std::string bytes;  // of the file
    std::vector<FigureData> data;  // refer to the run and to the request
    std::vector<Problem> warnings{};  // what of the request it does not show
};

/// Paints a figure. The same run and request give the same bytes.
/// \throws CannotDraw
Figure paintFigure(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
