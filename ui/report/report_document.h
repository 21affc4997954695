// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A report as plain values: sections of texts, tables and figures in order. HTML and PDF
// are written from the same document, so that they have the same contents and numbers.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace keyblock {

/// Command: a line for a terminal, in a font of fixed width.
enum class ReportTextKind { Body, Answer, Warning, Command };

struct ReportText {
    std::string text;
    ReportTextKind kind = ReportTextKind::Body;
};

struct ReportColumn {
    std::string title;  // with the unit
    bool isNumber = false;  // aligned to the right
};

struct ReportTable {
    std::string caption;  // without a full stop; tables are numbered by the writer
    std::vector<ReportColumn> columns;
    std::vector<std::vector<std::string>> rows;  // a cell for each column
};

struct ReportFigure {
    std::string caption;  // without a full stop; figures are numbered by the writer
    std::string svg;
    double width = 0.0, height = 0.0;  // [mm]
};

using ReportPart = std::variant<ReportText, ReportTable, ReportFigure>;

struct ReportSection {
    std::string heading;
    std::vector<ReportPart> parts;
};

/// Picture of a company or project; PNG, JPEG or SVG.
struct ReportLogo {
    std::string bytes;
    std::string mediaType;  // image/png, image/jpeg or image/svg+xml

    bool operator==(const ReportLogo&) const = default;
};

struct ReportDocument {
    std::string title;
    std::optional<ReportLogo> logo;
    std::vector<std::pair<std::string, std::string>> facts;  // rows of the title block: name and value
    std::vector<ReportSection> sections;
    std::string foot;  // at the foot of each page
};

}  // namespace keyblock
