// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures of a bolt, of the history and of events as files.
#include "solver/results/history.h"
#include "tests/ui/bricks.h"
#include "tests/ui/figure/reader.h"
#include "ui/figure/figure.h"

#include <gtest/gtest.h>

#include <sstream>

namespace keyblock {
namespace {

class OtherFigures : public ::testing::Test {
protected:
    OtherFigures() {
        Monitor pull;
        pull.name = "pull";
        pull.bolt = "B";
        pull.at = 0.7;
        bricks.scene.monitors = {pull};
        bricks.results.columns = historyColumns(bricks.scene);
        for (int i = 0; i < 5; ++i) {
            HistoryRow row;
            row.time = 0.1 * i;
            row.values.assign(bricks.results.columns.names.size(), 1e4 * i);
            bricks.results.history.push_back(row);
        }
    }
    Figure painted(FigureKind kind, PaperFormat format = PaperFormat::Svg) const {
        FigureRequest request;
        request.kind = kind;
        request.format = format;
        request.runName = "bricks";
        return painted(request);
    }
    Figure painted(const FigureRequest& request) const {
        return paintFigure(MemoryRun(bricks.scene, bricks.results), request);
    }
    std::string problemOf(const FigureRequest& request) const {
        try {
            painted(request);
        } catch (const CannotDraw& problem) {
            return problem.what();
        }
        return "";
    }
    test::BricksRun bricks;
};

constexpr FigureKind kinds[]{FigureKind::Bolt, FigureKind::Curves, FigureKind::Events};

TEST_F(OtherFigures, HaveTheSameBytesEachTime) {
    for (const FigureKind kind : kinds)
        for (const PaperFormat format : {PaperFormat::Svg, PaperFormat::Pdf, PaperFormat::Png})
            EXPECT_EQ(painted(kind, format).bytes, painted(kind, format).bytes);
}

TEST_F(OtherFigures, ContainTheirTextInPdf) {
    const std::vector<std::string> words[]{{"Bolt B: Bricks", "Axial force N (kN)", "distance from"},
                                           {"Bricks", "Axial force (kN)", "pull", "time (s)"},
                                           {"Events: Bricks", "joint slip", "B: 2 elements yield", "125 kN"}};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto text = test::readBy("pdftotext", "-layout % -", painted(kinds[k], PaperFormat::Pdf).bytes, ".pdf");
        if (!text) GTEST_SKIP() << "no poppler here";
        for (const std::string& word : words[k])
            EXPECT_NE(text->find(word), std::string::npos) << word << "\n" << *text;
    }
}

TEST_F(OtherFigures, WarnOfUnreliableResults) {
    StageResult result;
    result.outcome = Outcome::Duration;
    bricks.results.stages = {result};
    for (const FigureKind kind : {FigureKind::Section, FigureKind::Bolt, FigureKind::Curves, FigureKind::Events})
        EXPECT_EQ(painted(kind).bytes.find("Warning"), std::string::npos);
    bricks.results.stages[0].health.balanceError = 0.76;
    for (const FigureKind kind : {FigureKind::Section, FigureKind::Bolt, FigureKind::Curves, FigureKind::Events})
        EXPECT_NE(painted(kind).bytes.find("Warning: energy balance error of 76 %"), std::string::npos);
}

TEST_F(OtherFigures, WriteTheirDataNextToThem) {
    EXPECT_EQ(painted(FigureKind::Bolt).data.size(), 2u);
    EXPECT_EQ(painted(FigureKind::Bolt).data[1].suffix, "-envelope");
    std::ostringstream envelope;
    painted(FigureKind::Bolt).data[1].write(envelope);
    EXPECT_EQ(envelope.str().rfind("s_m,least_axial_force_N,largest_axial_force_N", 0), 0u) << envelope.str();
    EXPECT_EQ(painted(FigureKind::Curves).data.size(), 2u);
    EXPECT_EQ(painted(FigureKind::Events).data.size(), 1u);
}

/// Every word lies on the sheet, as found by a PDF reader.
TEST_F(OtherFigures, KeepNamesAndLegendsOnTheNarrowestPaper) {
    const std::string name = "a monitor of the northern ventilation drift at chainage four hundred and twelve";
    Monitor gap;
    gap.name = name;
    gap.between = {{Point(0.0, 1.0), Point(0.0, 1.1)}};
    bricks.scene.monitors.push_back(gap);
    bricks.results.columns = historyColumns(bricks.scene);
    for (HistoryRow& row : bricks.results.history) row.values.assign(bricks.results.columns.names.size(), 1e3 * row.time);
    FigureRequest request;
    request.format = PaperFormat::Pdf;
    request.width = 80.0;
    request.runName = "bricks";
    request.references = {{"lab.csv", name + ", laboratory", {}, {{"x_mm", "x", Measure::Length, {0.0, 1.0}},
                                                                 {"y_kN", "y", Measure::Force, {0.0, 1.0}}}}};
    for (const FigureKind kind : kinds) {
        request.kind = kind;
        const auto words = test::readBy("pdftotext", "-bbox % -", painted(request).bytes, ".pdf");
        if (!words) GTEST_SKIP() << "no poppler here";
        const double most = 80.0 / 25.4 * 72.0;  // in points
        for (std::size_t at = words->find("<word "); at != std::string::npos; at = words->find("<word ", at + 1)) {
            const auto value = [&](const std::string& key) {
                return std::stod(words->substr(words->find(key + "=\"", at) + key.size() + 2));
            };
            EXPECT_GE(value("xMin"), 0.0) << words->substr(at, 120);
            EXPECT_LE(value("xMax"), most) << words->substr(at, 120);
        }
    }
}

TEST_F(OtherFigures, MissingDataAreReported) {
    FigureRequest bolt;
    bolt.kind = FigureKind::Bolt;
    bolt.quantity = "slip";
    EXPECT_NE(problemOf(bolt).find("--quantity"), std::string::npos);
    FigureRequest curves;
    curves.kind = FigureKind::Curves;
    curves.quantity = "push";
    EXPECT_NE(problemOf(curves).find("monitors: pull"), std::string::npos);
    bricks.results = {};
    bolt.quantity.reset();
    EXPECT_NE(problemOf(bolt).find("no frame"), std::string::npos);
    curves.quantity.reset();
    EXPECT_NE(problemOf(curves).find("no history"), std::string::npos);
    FigureRequest events;
    events.kind = FigureKind::Events;
    EXPECT_NE(problemOf(events).find("not begun"), std::string::npos);
}

}  // namespace
}  // namespace keyblock
