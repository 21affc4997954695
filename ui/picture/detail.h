// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Details omitted from a section at its scale, the same on paper and on the screen:
// marks that would crowd each other, and blocks with displacements too small to see.
// Sizes are in units of the paper: millimetres there, pixels here.
#pragma once

#include "ui/picture/section.h"

#include <array>
#include <vector>

namespace keyblock {

struct DetailSizes {
    double shank;  // width of a bolt's line
    double betweenMarks;  // between marks of one bolt
    double moved;  // smallest displacement of a block whose initial outline is drawn
    double scaleForArtificial;  // units per metre below which intermediate points are not drawn
    double spacingForMarks, spacingForPlates;  // between bolts; below it marks (plates) are dropped except for failures
    double boltForMarks;  // length of a bolt; the same
};

bool isArtificial(MarkKind kind);

/// Unit vector from the first to the last; along x where they meet.
Point alongOf(const std::vector<Point>& nodes);

/// Whether two bolts coincide within `apart` [m]: no thinner line would separate them.
bool coincide(const BoltShape& a, const BoltShape& b, double apart);

/// From the head of each bolt to the nearest other bolt, as drawn at `scale` [units per m]; 1e9 for a single one.
std::vector<double> boltSpacing(const SectionPicture& picture, double scale, const DetailSizes& sizes);

/// From the middle of a bolt to the nearest other one [m]; 1e9 for a single one. \param apart as for `coincide`.
double middleSpacing(const SectionPicture& picture, std::size_t shape, double apart);

/// The marks of a bolt that are drawn, the most important last. \param spacing of that bolt, as above.
std::vector<Mark> marksToDraw(const BoltShape& bolt, double spacing, double scale, const DetailSizes& sizes);

/// Kinds of marks in the key of a picture.
inline constexpr std::array keyOrder{MarkKind::Bonded,   MarkKind::Artificial, MarkKind::Slipping,
                                     MarkKind::Gone,     MarkKind::Ruptured,   MarkKind::Yielded,
                                     MarkKind::InGap,    MarkKind::Plate,      MarkKind::PlateLost};

/// The kinds among the marks of all bolts, each once, in the order of the key.
std::vector<MarkKind> kindsOf(const std::vector<std::vector<Mark>>& marks);

/// Blocks that moved so far that their initial outline is drawn too; none if nearly all moved.
std::vector<const BlockShape*> movedBlocks(const SectionPicture& picture, double scale, const DetailSizes& sizes);

}  // namespace keyblock
