// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures of a report, the same as those that are exported one by one.
#pragma once

#include "ui/figure/figure.h"
#include "ui/report/report_facts.h"

#include <string>

namespace keyblock::report {

/// Adds a figure as wide as a page. If it cannot be drawn for this run, adds a sentence with the reason instead.
void addFigure(const Facts& facts, FigureRequest request, const std::string& caption, ReportSection& section);

/// Adds a figure that was drawn before. \param svg as `paintFigure` and similar functions write it
void addSvg(const std::string& svg, const std::string& caption, ReportSection& section);

}  // namespace keyblock::report
