// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of a report on paper: widths of its columns and its rows as pieces of pages.
#pragma once

#include "ui/report/report_document.h"
#include "ui/report/report_pages.h"

#include <string>
#include <vector>

namespace keyblock {

/// Widths of the columns [mm]: as wide as their texts if all fit into `width`. Otherwise, no column is narrower than
/// its longest word, and texts are broken into lines.
std::vector<double> columnWidths(const ReportTable& table, double width);

/// The pieces of a table with its caption above it. \param number of the table in the report.
std::vector<PagePiece> tablePieces(const ReportTable& table, int number);

}  // namespace keyblock
