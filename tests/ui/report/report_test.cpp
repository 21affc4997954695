// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports of made-up results: contents, order, and files that need nothing else.
#include "ui/report/report.h"

#include "tests/ui/bricks.h"
#include "ui/figure/figure.h"
#include "ui/report/report_html.h"
#include "ui/report/report_pdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace keyblock {
namespace {

class Report : public ::testing::Test {
protected:
    Report() {
        request.project = "Drift <3> & \"more\"";
        request.author = "A. Author";
        request.runName = "bricks.kbrun";
        request.verification = "Not verified on this installation.";
        request.inputs = {{"scene", "bricks", std::string(64, 'a')}};
        request.commands = {"keyblock report bricks.kbrun --out bricks.pdf"};
        StageResult ended;
        ended.outcome = Outcome::Duration;
        ended.time = 0.1;
        bricks.results.stages = {ended};
        for (Frame& frame : bricks.results.frames) {
            frame.extremes.resize(1);
            frame.extremes[0].axialForce = {100e3, 0.75, 0, 0.1};
            frame.extremes[0].steel = {0.64, 0.75, 0, 0.1};
        }
    }
    ReportDocument document() const { return reportOf(MemoryRun(bricks.scene, bricks.results), request); }

    test::BricksRun bricks;
    ReportRequest request;
};

template <typename Part>
std::vector<Part> partsOf(const ReportSection& section) {
    std::vector<Part> parts;
    for (const ReportPart& part : section.parts)
        if (const Part* one = std::get_if<Part>(&part)) parts.push_back(*one);
    return parts;
}

TEST_F(Report, HasAllSectionsInOrder) {
    const ReportDocument report = document();
    ASSERT_EQ(report.sections.size(), defaultTemplate().sections.size());
    for (std::size_t i = 0; i < report.sections.size(); ++i) {
        EXPECT_EQ(report.sections[i].heading, rowOf(defaultTemplate().sections[i].content).heading);
        EXPECT_FALSE(report.sections[i].parts.empty()) << report.sections[i].heading;
        for (const ReportTable& table : partsOf<ReportTable>(report.sections[i]))
            for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.caption;
    }
    EXPECT_EQ(report.facts[0], std::pair(std::string("Project"), request.project));
    EXPECT_FALSE(std::ranges::count(report.facts, "Date", &std::pair<std::string, std::string>::first));
    const auto figures = partsOf<ReportFigure>(report.sections[1]);
    ASSERT_EQ(figures.size(), 2U);
    for (const ReportFigure& figure : figures) {
        EXPECT_EQ(figure.width, 166.0);
        EXPECT_GT(figure.height, 20.0);
    }
}

TEST_F(Report, ShowsTheEstimatedErrors) {
    const auto tables = [this] {
        const ReportDocument report = document();
        return partsOf<ReportTable>(report.sections.at(4));
    };
    const std::size_t without = tables().size();
    request.estimate = ErrorEstimate{
        {"half the time step"},
        {{"max pull", 2e4, 500.0, ""}, {"order yield", {}, 0.25, ""}, {"none", {}, {}, "no value"}}};
    ASSERT_EQ(tables().size(), without + 1);
    const ReportTable table = tables().back();
    EXPECT_EQ(table.rows.at(0), (std::vector<std::string>{"max pull", "20000", "± 500", "2.5", ""}));
    EXPECT_EQ(table.rows.at(1), (std::vector<std::string>{"order yield", "–", "–", "25", "of the order differs"}));
    EXPECT_EQ(table.rows.at(2), (std::vector<std::string>{"none", "–", "–", "–", "no value"}));
}

/// 100 kN in a bar of 20 mm that yields at 400 MPa, 125.7 kN.
TEST_F(Report, ShowsTheUseOfABolt) {
    const ReportDocument report = document();
    const auto section = std::ranges::find(report.sections, "Bolts", &ReportSection::heading);
    ASSERT_NE(section, report.sections.end());
    const ReportTable peaks = partsOf<ReportTable>(*section).at(0);
    const auto cell = [&peaks](const std::string& title) {
        return peaks.rows.at(0).at(std::ranges::find(peaks.columns, title, &ReportColumn::title) -
                                   peaks.columns.begin());
    };
    EXPECT_EQ(cell("Axial, kN"), "100");
    EXPECT_EQ(cell("Yield"), "79.6");
    EXPECT_EQ(cell("Steel"), "64");
    EXPECT_EQ(cell("Moment, kN m"), "–");
    EXPECT_EQ(partsOf<ReportFigure>(*section).size(), 1U);
    const ReportSection& events = section[1];
    EXPECT_EQ(partsOf<ReportTable>(events).at(0).rows.size(), 3U);  // slips are counted only
}

TEST_F(Report, FollowsItsTemplate) {
    const TemplateReading reading = readTemplate(
        "title Ours\n[text: Scope]\nOnly bricks.\n[verification: Is it verified?]\n");
    request.layout = *reading.layout;
    const ReportDocument report = document();
    EXPECT_EQ(report.title, "Ours");
    ASSERT_EQ(report.sections.size(), 2U);
    EXPECT_EQ(report.sections[0].heading, "Scope");
    EXPECT_EQ(partsOf<ReportText>(report.sections[0]).at(0).text, "Only bricks.");
    EXPECT_EQ(report.sections[1].heading, "Is it verified?");
    EXPECT_EQ(partsOf<ReportText>(report.sections[1]).at(0).text, request.verification);
}

TEST_F(Report, OfARunWithoutResultsSaysSo) {
    bricks.results = {};
    bricks.scene.bolts.clear();
    const ReportDocument report = document();
    for (const ReportSection& section : report.sections) EXPECT_FALSE(section.parts.empty()) << section.heading;
    EXPECT_FALSE(reportHtml(report).empty());
    EXPECT_FALSE(reportPdf(report).empty());
}

TEST_F(Report, StopsBetweenSections) {
    struct Stopped {};
    request.progress = [](const std::string& heading, double) {
        if (heading == "Bolts") throw Stopped();
    };
    EXPECT_THROW(document(), Stopped);
}

TEST_F(Report, AsHtmlNeedsNoOtherFileAndEscapesNames) {
    request.logo = ReportLogo{"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 4 2\"/>", "image/svg+xml"};
    const std::string html = reportHtml(document());
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
    EXPECT_NE(html.find("<dd>Drift &lt;3&gt; &amp; &quot;more&quot;</dd>"), std::string::npos);
    EXPECT_EQ(html.find("http:"), std::string::npos);  // figures are encoded
    EXPECT_EQ(html.find("https:"), std::string::npos);
    const std::regex source(R"re((src|href)="([^"]{0,5}))re");
    for (auto it = std::sregex_iterator(html.begin(), html.end(), source); it != std::sregex_iterator(); ++it)
        EXPECT_TRUE((*it)[2].str() == "data:" || (*it)[2].str().starts_with("#")) << it->str();
    EXPECT_EQ(html, reportHtml(document()));
}

TEST_F(Report, AsPdfHasTheSameBytesEachTime) {
    const std::string pdf = reportPdf(document());
    EXPECT_TRUE(pdf.starts_with("%PDF"));
    EXPECT_EQ(pdf, reportPdf(document()));
    request.logo = ReportLogo{"not a picture", "image/png"};
    EXPECT_THROW(reportPdf(document()), CannotDraw);
}

}  // namespace
}  // namespace keyblock
