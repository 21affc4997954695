// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The template of a report: a plain text that chooses and orders its sections, gives them
// headings and introductions, and names a logo.
#pragma once

#include "ui/report/report_document.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

enum class ReportKind { Run, Study };

enum class ReportContent {
    Summary,
    Sections,
    Model,
    Stages,
    Numerics,
    Bolts,
    Events,
    Curves,
    Diagnostics,
    Parameters,
    Results,
    Verification,
    Inputs,
    Reproduce,
    Text
};

struct ReportContentRow {
    ReportContent content;
    std::string_view word;  // in templates
    std::string_view heading;
    std::optional<ReportKind> only{};  // applies to reports of this kind only; null: to both
};

/// All contents, in the order of `ReportContent` and of reports without a template.
inline constexpr std::array reportContents{
    ReportContentRow{ReportContent::Summary, "summary", "Summary"},
    ReportContentRow{ReportContent::Sections, "sections", "Section before and after", ReportKind::Run},
    ReportContentRow{ReportContent::Model, "model", "Model and materials", ReportKind::Run},
    ReportContentRow{ReportContent::Stages, "stages", "Stages", ReportKind::Run},
    ReportContentRow{ReportContent::Numerics, "numerics", "Numerical settings and accuracy", ReportKind::Run},
    ReportContentRow{ReportContent::Bolts, "bolts", "Bolts", ReportKind::Run},
    ReportContentRow{ReportContent::Events, "events", "Events and their causes", ReportKind::Run},
    ReportContentRow{ReportContent::Curves, "curves", "Curves", ReportKind::Run},
    ReportContentRow{ReportContent::Diagnostics, "diagnostics", "Solver diagnostics", ReportKind::Run},
    ReportContentRow{ReportContent::Parameters, "parameters", "What varies", ReportKind::Study},
    ReportContentRow{ReportContent::Results, "results", "Results of the cases", ReportKind::Study},
    ReportContentRow{ReportContent::Verification, "verification", "Verification"},
    ReportContentRow{ReportContent::Inputs, "inputs", "Inputs"},
    ReportContentRow{ReportContent::Reproduce, "reproduce", "How to make this report again"},
    ReportContentRow{ReportContent::Text, "text", ""}};  // texts of the template only

constexpr const ReportContentRow& rowOf(ReportContent content) {
    return reportContents.at(static_cast<std::size_t>(content));
}

constexpr bool appliesTo(const ReportContentRow& row, ReportKind kind) { return !row.only || *row.only == kind; }

/// A section of a template.
struct TemplateSection {
    ReportContent content = ReportContent::Summary;
    std::string heading;  // empty: that of the content
    std::vector<std::string> paragraphs{};  // written below the heading

    bool operator==(const TemplateSection&) const = default;
};

struct ReportTemplate {
    std::string title;  // empty: that of the scene or study
    std::string logo;  // path of a picture as written in the template; empty: none
    std::vector<TemplateSection> sections;

    bool operator==(const ReportTemplate&) const = default;
};

/// The template of a report for which the user gives none: all contents that apply to it.
ReportTemplate defaultTemplate(ReportKind kind = ReportKind::Run);

struct TemplateReading {
    std::optional<ReportTemplate> layout;
    std::string problem;  // what is wrong, with the number of the line, and what to do; empty if the template is valid
};

/// Reads a template. Lines before the first section are `title TEXT` and `logo FILE`; `[NAME]` or `[NAME: HEADING]`
/// begins a section; all other lines are its introduction, in paragraphs separated by empty lines. Lines that begin
/// with `#` are comments.
TemplateReading readTemplate(std::string_view text);

/// The template as text; `readTemplate` gives the same template again.
std::string templateText(const ReportTemplate& layout);

/// Media type of a picture, from the first bytes of its file; empty if it is not PNG, JPEG or SVG.
std::string mediaTypeOf(std::string_view bytes);

}  // namespace keyblock
