// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures for a report, painted without a screen: the interface to Qt for all code that
// needs a picture of a run on paper. This header does not need Qt.
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

/// Used instead of a quantity of a section: blocks or bolts are not coloured.
inline constexpr std::string_view plainWord = "plain";

struct FigureRequest {
    FigureKind kind = FigureKind::Section;
    PaperFormat format = PaperFormat::Svg;
    TableFilter filter;  // time and bolt
    std::optional<std::string> quantity;
    double width = 160.0;  // [mm]
    int dpi = 300;  // of PNG
    double factor = 1.0;  // scale factor of displacements
    bool whole = false;  // the whole model, not the surroundings of tunnels and bolts
    ScaleChoices scales{};  // of the colours of a section
    std::optional<Box> window;  // of a section [m]; null: as `whole` says
    std::optional<std::string> boltQuantity;  // of a section; null: as `quantity` says, else the axial force
    std::string title;  // empty: the figure's own
    std::vector<ReferenceTable> references{};  // drawn with the curves
    std::string runName;  // for the footer of the figure
};

/// The request cannot be drawn for this run; the message says what to request instead.
struct CannotDraw : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A table of the data shown in the figure.
struct FigureData {
    std::string suffix;  // of the file's name, before .csv
    std::function<void(std::ostream&)> write;
};

struct Figure {
    std::string bytes;  // of the file
    std::vector<FigureData> data;  // refer to the run and to the request
    std::vector<Problem> warnings{};  // parts of the request that it does not show
};

/// Paints a figure. The same run and request give the same bytes.
/// \throws CannotDraw
Figure paintFigure(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
