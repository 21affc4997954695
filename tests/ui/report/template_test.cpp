// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Templates choose and order sections; what cannot be read is reported with its line.
#include "ui/report/report_template.h"

#include <gtest/gtest.h>

#include <set>

namespace keyblock {
namespace {

TEST(ReportTemplate, ChoosesAndOrdersSections) {
    const TemplateReading reading = readTemplate(
        "\xEF\xBB\xBF# ours\r\ntitle Drift 3, support\nlogo  our logo.png\n\n"
        "[bolts: Support by bolts]\n\n# not shown\nFirst\nparagraph.\n\n"
        "Second.\n[text: Scope]\nA drift.\n[summary]\n");
    ASSERT_TRUE(reading.layout) << reading.problem;
    EXPECT_EQ(reading.layout->title, "Drift 3, support");
    EXPECT_EQ(reading.layout->logo, "our logo.png");
    const std::vector<TemplateSection> sections{
        {ReportContent::Bolts, "Support by bolts", {"First paragraph.", "Second."}},
        {ReportContent::Text, "Scope", {"A drift."}},
        {ReportContent::Summary, "", {}}};
    EXPECT_EQ(reading.layout->sections, sections);
}

TEST(ReportTemplate, ReportsTheLineThatIsWrong) {
    const auto problem = [](const char* text) { return readTemplate(text).problem; };
    EXPECT_TRUE(
        problem("[summary]\n[boltz]\n").starts_with("line 2: there is no section 'boltz'; there are summary, "));
    EXPECT_TRUE(problem("\n[summary\n").starts_with("line 2: '[summary' has no ']'"));
    EXPECT_TRUE(problem("Hello\n[summary]\n").starts_with("line 1: 'Hello' is neither title nor logo"));
    EXPECT_TRUE(problem("logo\n[summary]\n").starts_with("line 1: 'logo' has no value"));
    EXPECT_TRUE(problem("[text]\n").starts_with("line 1: a text needs a heading"));
    EXPECT_TRUE(problem("").starts_with("line 1: there is no section"));
}

TEST(ReportTemplate, HasARowForEachContent) {
    std::set<std::string_view> words;
    for (const ReportContentRow& row : reportContents) {
        EXPECT_EQ(&rowOf(row.content), &row);
        words.insert(row.word);
    }
    EXPECT_EQ(words.size(), reportContents.size());
    EXPECT_EQ(words.size(), static_cast<std::size_t>(ReportContent::Text) + 1);
    for (const ReportKind kind : {ReportKind::Run, ReportKind::Study})
        for (const TemplateSection& section : defaultTemplate(kind).sections)
            EXPECT_TRUE(appliesTo(rowOf(section.content), kind)) << rowOf(section.content).word;
    EXPECT_EQ(defaultTemplate().sections.size(), words.size() - 3);  // two of studies, and texts
    EXPECT_EQ(defaultTemplate(ReportKind::Study).sections.size(), 6U);
}

TEST(ReportTemplate, RecognisesPictures) {
    EXPECT_EQ(mediaTypeOf("\x89PNG\r\n\x1A\n...."), "image/png");
    EXPECT_EQ(mediaTypeOf("\xFF\xD8\xFF\xE0"), "image/jpeg");
    EXPECT_EQ(mediaTypeOf("<?xml version=\"1.0\"?>\n<svg/>"), "image/svg+xml");
    EXPECT_EQ(mediaTypeOf("a text about <svg"), "");
    EXPECT_EQ(mediaTypeOf(""), "");
}

TEST(ReportTemplate, WrittenTemplateIsReadBack) {
    const ReportTemplate layout{"Drift 3",
                                "logo.png",
                                {{ReportContent::Bolts, "Support by bolts", {"First paragraph.", "Second."}},
                                 {ReportContent::Text, "Scope", {"A drift."}},
                                 {ReportContent::Summary, "", {}}}};
    const TemplateReading reading = readTemplate(templateText(layout));
    ASSERT_TRUE(reading.layout) << reading.problem;
    EXPECT_EQ(*reading.layout, layout);
    EXPECT_EQ(*readTemplate(templateText(defaultTemplate())).layout, defaultTemplate());
}

}  // namespace
}  // namespace keyblock
