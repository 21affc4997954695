// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures for reports, drawn without a screen. All code that needs a figure of a run on
// paper uses this interface to Qt; the header itself does not need Qt.
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

/// True if the figure contains charts, which only the window's thread can draw.
constexpr bool hasCharts(FigureKind kind) { return kind == FigureKind::Bolt || kind == FigureKind::Curves; }
enum class PaperFormat { Svg, Pdf, Png };

/// Word used instead of the name of a quantity to request a section with uncoloured blocks and bolts.
inline constexpr std::string_view plainWord = "plain";

struct FigureRequest {
    FigureKind kind = FigureKind::Section;
    PaperFormat format = PaperFormat::Svg;
    TableFilter filter;  // selects time and bolt
    std::optional<std::string> quantity;
    double width = 160.0;  // [mm]
    int dpi = 300;  // resolution, for PNG
    double factor = 1.0;  // scale factor of displacements
    bool whole = false;  // show the whole model, not only the surroundings of tunnels and bolts
    ScaleChoices scales{};  // colour ranges of a section
    std::optional<Box> window;  // part of the section to show [m]; null: according to `whole`
    std::optional<std::string> boltQuantity;  // for bolts in a section; null: as `quantity`, or axial force
    std::string title;  // empty: the default title of the figure
    std::vector<ReferenceTable> references{};  // drawn together with the curves
    std::string runName;  // shown in the footer
};

/// Thrown if a request cannot be drawn for the run; the message says what to request instead.
struct CannotDraw : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A table of the data shown in the figure.
struct FigureData {
    std::string suffix;  // of the file name, before `.csv`
    std::function<void(std::ostream&)> write;
};

struct Figure {
    std::string bytes;  // contents of the file
    std::vector<FigureData> data;  // refer to the run and the request, which must outlive them
    std::vector<Problem> warnings{};  // parts of the request that the figure does not show
};

/// Draws a figure. The same run and request always give the same bytes. \throws CannotDraw
Figure paintFigure(const RunSource& run, const FigureRequest& request);

}  // namespace keyblock
