// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a section leaves out at the scale it is drawn at, the same on paper and on
// the screen: marks that would crowd each other, and blocks whose way is too short
// to be seen. Sizes are in units of the paper: millimetres there, pixels here.
#pragma once

#include "ui/picture/section.h"

#include <array>
#include <vector>

namespace keyblock {

struct DetailSizes {
    double shank;  // width of a bolt's line
    double betweenMarks;  // that those of one bolt keep
    double moved;  // least way of a block that is shown where it was
    double scaleForArtificial;  // units per metre below which artificial points are not drawn
    double spacingForMarks, spacingForPlates;  // between bolts; below it marks (plates) give way but for what let go
    double boltForMarks;  // length of a bolt, likewise
};

bool isArtificial(MarkKind kind);

/// Unit vector from the first to the last; along x where they meet.
Point alongOf(const std::vector<Point>& nodes);

/// Whether two bolts lie on one another within `apart` [m]: no smaller stroke would part them.
bool coincide(const BoltShape& a, const BoltShape& b, double apart);

/// From the head of each bolt to the nearest other bolt, as drawn at `scale` [units per m]; 1e9 of a lonely one.
std::vector<double> boltSpacing(const SectionPicture& picture, double scale, const DetailSizes& sizes);

/// From the middle of a bolt to the nearest other one [m]; 1e9 of a lonely one. \param apart as for `coincide`.
double middleSpacing(const SectionPicture& picture, std::size_t shape, double apart);

/// The marks of a bolt that are drawn, what matters most last. \param spacing of that bolt, as above.
std::vector<Mark> marksToDraw(const BoltShape& bolt, double spacing, double scale, const DetailSizes& sizes);

/// Kinds of marks as the key of a picture tells them.
inline constexpr std::array keyOrder{MarkKind::Bonded,   MarkKind::Artificial, MarkKind::Slipping,
                                     MarkKind::Gone,     MarkKind::Ruptured,   MarkKind::Yielded,
                                     MarkKind::InGap,    MarkKind::Plate,      MarkKind::PlateLost};

/// The kinds among the marks of all bolts, each once, in the order of the key.
std::vector<MarkKind> kindsOf(const std::vector<std::vector<Mark>>& marks);

/// Those that went so far that the eye asks where they came from; none where nearly everything moved.
std::vector<const BlockShape*> movedBlocks(const SectionPicture& picture, double scale, const DetailSizes& sizes);

}  // namespace keyblock
