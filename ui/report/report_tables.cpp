// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_tables.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace keyblock {

namespace {

constexpr double cellGap = 2.4, rowRoom = 1.5, cellLine = 3.2, captionLine = 3.9;  // [mm]
constexpr double longestWord = 34.0;  // longer words are broken [mm]
constexpr double keptWidth = 24.0;  // texts up to this width are not broken if there is room [mm]
const TextStyle cellStyle{2.35}, headStyle{2.35, true}, captionStyle{2.7, true};

double longestWordWidth(const std::string& text, const TextStyle& style) {
    double longest = 0.0;
    std::istringstream words(text);
    for (std::string word; words >> word;) longest = std::max(longest, textWidth(word, style));
    return longest;
}

/// The title of a column with its unit kept next to the word before it.
std::string columnTitle(std::string title) {
    const std::size_t comma = title.rfind(", ");
    if (comma != std::string::npos) title.replace(comma, 2, ",\u00A0");
    return title;
}

/// Lines of each cell of a row.
using CellLines = std::vector<std::vector<std::string>>;

CellLines linesOf(const std::vector<std::string>& cells, const std::vector<double>& widths, const TextStyle& style) {
    CellLines lines;
    for (std::size_t c = 0; c < cells.size(); ++c) lines.push_back(brokenLines(cells[c], style, widths[c] - cellGap));
    return lines;
}

PagePiece rowPiece(const ReportTable& table, CellLines lines, const std::vector<double>& widths, const TextStyle& style,
                   const Stroke& rule) {
    std::size_t most = 1;
    for (const auto& cell : lines) most = std::max(most, cell.size());
    PagePiece piece;
    piece.height = rowRoom + cellLine * static_cast<double>(most);
    const bool atBottom = style.bold;  // titles of columns stand on the rule
    piece.draw = [&table, lines = std::move(lines), widths, style, rule, most, atBottom, height = piece.height](
                     Ink& ink, double top) {
        double x = report_page::left;
        for (std::size_t c = 0; c < lines.size(); ++c) {
            const std::size_t skipped = atBottom ? most - lines[c].size() : 0;
            for (std::size_t l = 0; l < lines[c].size(); ++l) {
                const double y = top + cellLine * static_cast<double>(l + skipped + 1);
                if (table.columns[c].isNumber) ink.text({x + widths[c] - cellGap, y}, lines[c][l], style, Align::Right);
                else ink.text({x, y}, lines[c][l], style);
            }
            x += widths[c];
        }
        ink.line({report_page::left, top + height}, {x - cellGap, top + height}, rule);
    };
    return piece;
}

/// Widths between the least and the natural ones whose sum is `width`.
std::vector<double> between(const std::vector<double>& least, const std::vector<double>& natural, double width) {
    const double needed = std::accumulate(least.begin(), least.end(), 0.0);
    const double share = (width - needed) / (std::accumulate(natural.begin(), natural.end(), 0.0) - needed);
    std::vector<double> widths;
    for (std::size_t c = 0; c < least.size(); ++c) widths.push_back(least[c] + share * (natural[c] - least[c]));
    return widths;
}

std::vector<double> scaled(std::vector<double> widths, double factor) {
    for (double& width : widths) width *= factor;
    return widths;
}

}  // namespace

std::vector<double> columnWidths(const ReportTable& table, double width) {
    std::vector<double> natural, least;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        natural.push_back(textWidth(columnTitle(table.columns[c].title), headStyle));
        least.push_back(longestWordWidth(columnTitle(table.columns[c].title), headStyle));
        for (const auto& row : table.rows) {
            const double cell = textWidth(row[c], cellStyle);
            natural.back() = std::max(natural.back(), cell);
            // numbers with their units are not broken
            least.back() = std::max(least.back(), table.columns[c].isNumber
                                                      ? cell
                                                      : std::min(longestWord, longestWordWidth(row[c], cellStyle)));
        }
        natural.back() += cellGap + 0.1;  // round-off does not break a line
        least.back() += cellGap + 0.1;
    }
    const double wanted = std::accumulate(natural.begin(), natural.end(), 0.0);
    const double needed = std::accumulate(least.begin(), least.end(), 0.0);
    if (wanted <= width) return natural;
    std::vector<double> kept(least);
    for (std::size_t c = 0; c < least.size(); ++c) kept[c] = std::max(least[c], std::min(natural[c], keptWidth));
    if (std::accumulate(kept.begin(), kept.end(), 0.0) < width) return between(kept, natural, width);
    return needed < width ? between(least, natural, width) : scaled(least, width / needed);
}

std::vector<PagePiece> tablePieces(const ReportTable& table, int number) {
    std::vector<PagePiece> pieces;
    const std::vector<std::string> caption = brokenLines("Table " + std::to_string(number) + ". " + table.caption + ".",
                                                         captionStyle, report_page::inner);
    pieces.push_back({captionLine * static_cast<double>(caption.size()) + 1.0, [caption](Ink& ink, double top) {
                          for (std::size_t l = 0; l < caption.size(); ++l)
                              ink.text({report_page::left, top + captionLine * static_cast<double>(l + 1) - 0.8},
                                       caption[l], captionStyle);
                      }});
    pieces.back().staysWithNext = true;
    const std::vector<double> widths = columnWidths(table, report_page::inner + cellGap);
    std::vector<std::string> titles;
    for (const ReportColumn& column : table.columns) titles.push_back(columnTitle(column.title));
    auto head = std::make_shared<PagePiece>(
        rowPiece(table, linesOf(titles, widths, headStyle), widths, headStyle, {0.25, paper_theme::black}));
    pieces.push_back(*head);
    pieces.back().staysWithNext = !table.rows.empty();
    for (const auto& row : table.rows) {
        pieces.push_back(rowPiece(table, linesOf(row, widths, cellStyle), widths, cellStyle, {0.1, paper_theme::axis}));
        if (pieces.size() > 3) pieces.back().head = head;  // the first row follows the head itself
    }
    return pieces;
}

}  // namespace keyblock
