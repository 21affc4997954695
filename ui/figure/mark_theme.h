// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours and sizes of the marks on bolts: one set for paper in millimetres, and one
// for the screen in pixels. The shapes are the same.
#pragma once

#include "ui/figure/ink.h"

namespace keyblock {

struct MarkColours {
    Colour ink = paper_theme::black, casing = paper_theme::white;
    Colour hollow = paper_theme::white;  // inside rings and open rectangles
    Colour soft = paper_theme::softText, slipping = paper_theme::slipping;
    Colour rim = paper_theme::black;  // around slipping nodes
    Colour error = paper_theme::error, yielded = paper_theme::yielded;
};

/// Sizes of marks in drawing units (mm or px). A pair consists of the usual size and a small size for bolts with many
/// marks.
struct MarkSizes {
    struct Pair {
        double usual, small;
        double of(bool isSmall) const { return isSmall ? small : usual; }
    };
    double casing = 0.12;  // light outline around each mark
    double line = 0.17;  // line width of rings and rims
    double stroke = 0.28;  // line width of crosses, chevrons and struck-through marks
    Pair disc{0.75, 0.5}, ring{0.5, 0.38}, diamond{1.0, 0.75}, cross{0.65, 0.5};
    double dash = 0.35, gap = 0.25;
    double square = 0.47;  // half of the side length
    double chevronFrom = 0.35, chevronTo = 1.0, chevronAcross = 0.8;
    double plateAlong = 0.28, plateAcross = 1.08;  // half of the sides of a face plate
    double lostAlong = 0.38, lostAcross = 1.15;  // half of the sides of a lost face plate
    double lostAway = 0.9, lostTilt = 0.0;  // distance of a lost plate from the head, and its rotation [rad]
};

struct MarkTheme {
    MarkColours colours;
    MarkSizes sizes;
};

inline const MarkTheme paperMarks{};

/// Sizes on the screen [px].
inline constexpr MarkSizes screenMarkSizes{
    .casing = 1.2, .line = 1.2, .stroke = 1.9, .disc = {4.4, 3.3}, .ring = {3.1, 2.6}, .diamond = {5.7, 4.6},
    .cross = {4.2, 3.4}, .dash = 1.8, .gap = 1.4, .square = 4.0, .chevronFrom = 2.0, .chevronTo = 6.2,
    .chevronAcross = 5.4, .plateAlong = 2.2, .plateAcross = 6.0, .lostAlong = 2.0, .lostAcross = 5.6, .lostAway = 7.0, .lostTilt = 0.5};

}  // namespace keyblock
