// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a report from top to bottom as pieces of known height, and their
// distribution over pages.
#pragma once

#include "ui/figure/ink.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace keyblock {

/// Size of the pages and of the area for their contents [mm].
namespace report_page {
inline constexpr double width = 210.0, height = 297.0;  // A4
inline constexpr double left = 22.0, top = 22.0, inner = width - 2.0 * left, bottom = height - 22.0;
}  // namespace report_page

/// A part of a page that is not divided.
struct PagePiece {
    double height = 0.0;  // [mm]
    std::function<void(Ink&, double top)> draw;  // draws with the upper edge at `top` [mm]
    bool staysWithNext = false;  // on the same page as the next piece, if both fit on a page
    bool isGap = false;  // left out at the top of a page
    std::shared_ptr<const PagePiece> head{};  // repeated above this piece at the top of a page: the head of its table
    int section = -1;  // index of the section whose heading this is; −1: none
};

/// A piece at its position on a page.
struct PlacedPiece {
    std::size_t page = 0;
    double top = 0.0;  // [mm]
    const PagePiece* piece = nullptr;
};

struct PageLayout {
    std::vector<PlacedPiece> pieces;
    std::size_t pages = 1;
    std::vector<std::size_t> sections;  // page of each section's heading, from 0
};

/// Distributes the pieces, which must outlive the result, over pages. A piece higher than a page begins on a page of its
/// own and extends beyond it.
PageLayout layOut(const std::vector<PagePiece>& pieces);

/// Text broken into lines of at most `width` [mm], at spaces or, in longer words, between letters.
std::vector<std::string> brokenLines(const std::string& text, const TextStyle& style, double width);

}  // namespace keyblock
