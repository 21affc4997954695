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
    Verification,
    Inputs,
    Reproduce,
    Text
};

struct ReportContentRow {
    ReportContent content;
    std::string_view word;  // in templates
    std::string_view heading;
};

/// All contents, in the order of `ReportContent` and of a report without a template.
inline constexpr std::array reportContents{
    ReportContentRow{ReportContent::Summary, "summary", "Summary"},
    ReportContentRow{ReportContent::Sections, "sections", "Section before and after"},
    ReportContentRow{ReportContent::Model, "model", "Model and materials"},
    ReportContentRow{ReportContent::Stages, "stages", "Stages"},
    ReportContentRow{ReportContent::Numerics, "numerics", "Numerical settings and accuracy"},
    ReportContentRow{ReportContent::Bolts, "bolts", "Bolts"},
    ReportContentRow{ReportContent::Events, "events", "Events and their causes"},
    ReportContentRow{ReportContent::Curves, "curves", "Curves"},
    ReportContentRow{ReportContent::Diagnostics, "diagnostics", "Solver diagnostics"},
    ReportContentRow{ReportContent::Verification, "verification", "Verification"},
    ReportContentRow{ReportContent::Inputs, "inputs", "Inputs"},
    ReportContentRow{ReportContent::Reproduce, "reproduce", "How to make this report again"},
    ReportContentRow{ReportContent::Text, "text", ""}};  // texts of the template only

constexpr const ReportContentRow& rowOf(ReportContent content) {
    return reportContents.at(static_cast<std::size_t>(content));
}

/// A section of a template.
struct TemplateSection {
    ReportContent content = ReportContent::Summary;
    std::string heading;  // empty: that of the content
    std::vector<std::string> paragraphs{};  // written below the heading

    bool operator==(const TemplateSection&) const = default;
};

struct ReportTemplate {
    std::string title;  // empty: that of the scene
    std::string logo;  // path of a picture as written in the template; empty: none
    std::vector<TemplateSection> sections;

    bool operator==(const ReportTemplate&) const = default;
};

/// The template of a report for which the user gives none: all contents.
ReportTemplate defaultTemplate();

struct TemplateReading {
    std::optional<ReportTemplate> layout;
    std::string problem;  // what is wrong, with the number of the line, and what to do; empty if the template is valid
};

/// Reads a template. Lines before the first section are `title TEXT` and `logo FILE`; `[NAME]` or `[NAME: HEADING]`
/// begins a section; all other lines are its introduction, in paragraphs separated by empty lines. Lines that begin
/// with `#` are comments.
TemplateReading readTemplate(std::string_view text);

/// Media type of a picture, from the first bytes of its file; empty if it is not PNG, JPEG or SVG.
std::string mediaTypeOf(std::string_view bytes);

}  // namespace keyblock
