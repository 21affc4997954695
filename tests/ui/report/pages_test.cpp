// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces are distributed over pages without being divided; tables repeat their head.
#include "ui/report/report_pages.h"
#include "ui/report/report_tables.h"

#include <gtest/gtest.h>

#include <numeric>

namespace keyblock {
namespace {

using namespace report_page;

constexpr double room = bottom - top;  // height of the contents of a page [mm]

PagePiece block(double high, bool staysWithNext = false) {
    PagePiece piece;
    piece.height = high;
    piece.staysWithNext = staysWithNext;
    return piece;
}

TEST(ReportPages, KeepAHeadingWithWhatFollows) {
    const std::vector<PagePiece> pieces{block(0.5 * room), block(0.2 * room, true), block(0.4 * room)};
    const PageLayout layout = layOut(pieces);
    ASSERT_EQ(layout.pieces.size(), 3U);
    EXPECT_EQ(layout.pages, 2U);
    EXPECT_EQ(layout.pieces[1].page, 1U);
    EXPECT_DOUBLE_EQ(layout.pieces[1].top, top);
    EXPECT_DOUBLE_EQ(layout.pieces[2].top, top + 0.2 * room);
}

TEST(ReportPages, LeaveGapsOutAtTheTop) {
    std::vector<PagePiece> pieces{block(0.9 * room), block(0.2 * room), block(0.1 * room)};
    pieces[1].isGap = true;
    const PageLayout layout = layOut(pieces);
    ASSERT_EQ(layout.pieces.size(), 2U);
    EXPECT_EQ(layout.pieces[1].page, 1U);
    EXPECT_DOUBLE_EQ(layout.pieces[1].top, top);
}

TEST(ReportPages, NumberTheSections) {
    std::vector<PagePiece> pieces{block(0.6 * room), block(0.6 * room), block(0.1 * room)};
    for (int i = 0; i < 3; ++i) pieces[i].section = i;
    EXPECT_EQ(layOut(pieces).sections, (std::vector<std::size_t>{0, 1, 1}));
}

ReportTable longTable(std::size_t rows) {
    ReportTable table{"Numbers", {{"Name"}, {"Value", true}}, {}};
    for (std::size_t i = 0; i < rows; ++i) table.rows.push_back({"row " + std::to_string(i), std::to_string(i)});
    return table;
}

TEST(ReportPages, RepeatTheHeadOfATable) {
    const ReportTable table = longTable(150);
    const std::vector<PagePiece> pieces = tablePieces(table, 1);
    ASSERT_EQ(pieces.size(), 2U + 150U);  // caption and head
    const PageLayout layout = layOut(pieces);
    EXPECT_GT(layout.pages, 2U);
    EXPECT_EQ(layout.pieces.size(), pieces.size() + layout.pages - 1);
    for (const PlacedPiece& placed : layout.pieces) EXPECT_LE(placed.top + placed.piece->height, bottom + 1e-9);
}

TEST(ReportPages, ColumnsFitThePage) {
    ReportTable table = longTable(1);
    EXPECT_LT(columnWidths(table, inner)[0], 0.2 * inner);  // no wider than its texts
    const std::string words =
        "many words that do not all fit into one line of a page, so that they are broken into "
        "several lines, while numbers are not broken, and so on and so forth until the end";
    table.columns.push_back({"Remark"});
    table.rows[0].push_back(words);
    const std::vector<double> widths = columnWidths(table, inner);
    EXPECT_NEAR(std::accumulate(widths.begin(), widths.end(), 0.0), inner, 1e-6);
    EXPECT_GT(widths[1], textWidth("Value", {2.35, true}));
}

TEST(ReportPages, BreakLinesAtSpacesAndLongWordsBetweenLetters) {
    const TextStyle style{3.0};
    const std::string word(300, 'm');
    const std::vector<std::string> lines = brokenLines("a b " + word + " c ü" + word, style, 50.0);
    std::string all;
    for (const std::string& line : lines) {
        EXPECT_LE(textWidth(line, style), 50.0);
        all += line;
    }
    std::erase(all, ' ');
    EXPECT_EQ(all, "ab" + word + "cü" + word);
    EXPECT_EQ(brokenLines("", style, 50.0), std::vector<std::string>{""});
    EXPECT_EQ(brokenLines("abc", style, 0.1).size(), 3U);
}

}  // namespace
}  // namespace keyblock
