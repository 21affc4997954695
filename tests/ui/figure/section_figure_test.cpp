// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures as files: exact sizes, the same bytes each time, text as text, and valid for
// a second reader.
#include "tests/ui/bricks.h"
#include "tests/ui/figure/reader.h"
#include "ui/figure/figure.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace keyblock {
namespace {

using test::readBy;

class SectionFigure : public ::testing::Test {
protected:
    std::string painted(PaperFormat format, double width = 160.0, int dpi = 300) const {
        FigureRequest request;
        request.format = format;
        request.width = width;
        request.dpi = dpi;
        request.runName = "bricks";
        return paintFigure(MemoryRun(run.scene, run.results), request).bytes;
    }
    test::BricksRun run;
};

double numberAfter(const std::string& text, const std::string& before) {
    const std::size_t at = text.find(before);
    return at == std::string::npos ? -1.0 : std::strtod(text.c_str() + at + before.size(), nullptr);
}

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

TEST_F(SectionFigure, HasTheSameBytesEachTime) {
    for (const PaperFormat format : {PaperFormat::Svg, PaperFormat::Pdf, PaperFormat::Png})
        EXPECT_EQ(painted(format), painted(format));
    EXPECT_EQ(painted(PaperFormat::Pdf).find("CreationDate"), std::string::npos);
}

TEST_F(SectionFigure, SvgHasItsSizeInMillimetresAndTextAsText) {
    const std::string svg = painted(PaperFormat::Svg, 120.0);
    EXPECT_DOUBLE_EQ(numberAfter(svg, "<svg width=\""), 120.0);
    EXPECT_NE(svg.find("120mm"), std::string::npos);
    for (const char* text : {"Bricks, stage lift at 0.1 s", "Block stress ", "MPa)", ">yield<", "B: 2 elements yield"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    EXPECT_EQ(svg.find("font-weight=\"630\""), std::string::npos);
}

TEST_F(SectionFigure, SvgIsReadByLibrsvg) {
    const auto png = readBy("rsvg-convert", "-d 300 -p 300 %", painted(PaperFormat::Svg), ".svg");
    if (!png) GTEST_SKIP() << "no rsvg-convert here";
    EXPECT_NEAR(bigEndian(*png, 16) * 25.4 / 300.0, 160.0, 0.2);
}

TEST_F(SectionFigure, PdfHasItsSizeFontsAndText) {
    const std::string pdf = painted(PaperFormat::Pdf);
    const auto info = readBy("pdfinfo", "%", pdf, ".pdf");
    if (!info) GTEST_SKIP() << "no poppler here";
    EXPECT_NEAR(numberAfter(*info, "Page size:") * 25.4 / 72.0, 160.0, 0.2);
    const std::string fonts = readBy("pdffonts", "%", pdf, ".pdf").value_or("");
    std::istringstream lines(fonts);
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("name", 0) == 0 || line.rfind("---", 0) == 0) continue;
        ++count;
        EXPECT_TRUE(std::regex_search(line, std::regex(" yes +(yes|no) +yes "))) << line;  // embedded, with Unicode
    }
    EXPECT_GE(count, 2);
    const std::string text = readBy("pdftotext", "-layout % -", pdf, ".pdf").value_or("");
    for (const char* word : {"Bricks, stage lift at 0.1 s", "Block stress", "(MPa)", "bonded", "elements yield"})
        EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
}

TEST_F(SectionFigure, PngHasItsSizeAndResolution) {
    for (const int dpi : {100, 300, 600}) {
        const std::string png = painted(PaperFormat::Png, 80.0, dpi);
        EXPECT_NEAR(bigEndian(png, 16) * 25.4 / dpi, 80.0, 0.2);
        const std::size_t physical = png.find("pHYs");
        ASSERT_NE(physical, std::string::npos);
        EXPECT_NEAR(bigEndian(png, physical + 4) * 0.0254, dpi, 0.02);
    }
}

TEST_F(SectionFigure, DataAreWrittenNextToIt) {
    const MemoryRun source(run.scene, run.results);
    const Figure figure = paintFigure(source, {});
    ASSERT_EQ(figure.data.size(), 3u);
    std::ostringstream blocks;
    figure.data[0].write(blocks);
    EXPECT_EQ(figure.data[0].suffix, "-blocks");
    EXPECT_NE(blocks.str().find("sigma1_compressive_Pa"), std::string::npos);
    const std::string table = blocks.str();
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);  // of that frame only
}

TEST_F(SectionFigure, AnUnknownQuantityIsReportedWithTheKnownOnes) {
    FigureRequest request;
    request.quantity = "happiness";
    try {
        paintFigure(MemoryRun(run.scene, run.results), request);
        FAIL();
    } catch (const CannotDraw& problem) {
        EXPECT_NE(std::string(problem.what()).find("sigma1"), std::string::npos);
        EXPECT_NE(std::string(problem.what()).find("moment"), std::string::npos);
    }
}

TEST_F(SectionFigure, EveryQuantityIsDrawn) {
    const MemoryRun source(run.scene, run.results);
    FigureRequest request;
    for (const auto& row : blockQuantities()) {
        request.quantity = std::string(row.name);
        EXPECT_FALSE(paintFigure(source, request).bytes.empty()) << row.name;
    }
    for (const auto& row : boltQuantities()) {
        request.quantity = std::string(row.name);
        EXPECT_FALSE(paintFigure(source, request).bytes.empty()) << row.name;
    }
}

TEST_F(SectionFigure, ARunWithoutFramesShowsItsScene) {
    run.results = {};
    const std::string svg = painted(PaperFormat::Svg);
    EXPECT_NE(svg.find("before the run"), std::string::npos);
    EXPECT_EQ(svg.find("MPa)"), std::string::npos);  // no legend
}

/// Bolts of several cases in one scene may coincide; no thinner line would separate them.
TEST_F(SectionFigure, CoincidentBoltsAreDrawn) {
    const std::string shank = "stroke-width=\"14\"";  // 0.7 mm
    ASSERT_NE(painted(PaperFormat::Svg).find(shank), std::string::npos);
    run.scene.bolts.push_back(run.scene.bolts[0]);
    run.scene.bolts[1].name = "C";
    for (Frame& frame : run.results.frames) frame.bolts.push_back(frame.bolts[0]);
    EXPECT_NE(painted(PaperFormat::Svg).find(shank), std::string::npos);
    run.scene.bolts[1].farEnd.x() += 0.02, run.scene.bolts[1].head.x() += 0.02;  // 0.5 mm on paper
    for (Frame& frame : run.results.frames)
        for (BoltNodeFrame& node : frame.bolts[1].nodes) node.position.x() += 0.02;
    EXPECT_EQ(painted(PaperFormat::Svg).find(shank), std::string::npos);
}

TEST_F(SectionFigure, ALongEventIsWrapped) {
    Event& pulled = run.results.events[2];
    pulled.kind = EventKind::PulledOut;
    pulled.node = 1;
    run.results.events.erase(run.results.events.begin() + 3);
    test::countEvents(run.results.events, run.results.frames);
    run.scene.bolts[0].name = "R1";
    const std::string svg = painted(PaperFormat::Svg, 120.0);
    EXPECT_NE(svg.find(">R1 has one"), std::string::npos);
    EXPECT_NE(svg.find("out</text>"), std::string::npos);
}

TEST_F(SectionFigure, LongNamesAreWrappedAndElided) {
    run.scene.title = std::string(40, 'W') + " " + std::string(300, 'W');
    run.scene.bolts[0].name = std::string(200, 'W');
    run.scene.stages[0].name = std::string(200, 'W');
    const std::string svg = painted(PaperFormat::Svg, 60.0);
    EXPECT_EQ(svg.find(std::string(60, 'W') + "</text>"), std::string::npos);
    EXPECT_NE(svg.find("…"), std::string::npos);
}

}  // namespace
}  // namespace keyblock
