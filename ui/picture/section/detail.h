// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects the details that a section shows at a given scale, by the same rules on paper
// and on screen: marks that would crowd each other are omitted, and so are initial
// outlines of blocks whose displacements are too small to see. Sizes are in drawing
// units: millimetres on paper, pixels on screen.
#pragma once

#include "ui/picture/section/section.h"

#include <array>
#include <vector>

namespace keyblock {

struct DetailSizes {
    double shank;  // width of the line of a bolt
    double betweenMarks;  // smallest distance between marks of one bolt
    double moved;  // smallest displacement for which the initial outline of a block is drawn
    double scaleForArtificial;  // scale [units per m] below which intermediate nodes are not drawn
    double spacingForMarks, spacingForPlates;  // bolt spacing below which these are omitted
    double boltForMarks;  // length of a bolt below which marks are omitted, except marks of failures
};

bool isArtificial(MarkKind kind);

/// Unit vector from the first of `nodes` to the last; the x direction if the two coincide.
Point alongOf(const std::vector<Point>& nodes);

/// True if both ends of one bolt are within `apart` [m] of those of the other, so that they cannot be drawn separately.
bool coincide(const BoltShape& a, const BoltShape& b, double apart);

/// For each bolt of the picture, the distance from its head to the nearest other bolt, in drawing units. A bolt that
/// coincides with this one is ignored. If there is no other bolt, the value is very large.
/// \param scale drawing units per metre.
std::vector<double> boltSpacing(const SectionPicture& picture, double scale, const DetailSizes& sizes);

/// Distance from the midpoint of a bolt to the nearest other bolt [m]; 1e9 if there is no other bolt. Bolts that
/// coincide with this one within `apart` [m] are ignored. \param shape index into `picture.bolts`.
double middleSpacing(const SectionPicture& picture, std::size_t shape, double apart);

/// The marks to draw on a bolt, in ascending order of importance.
/// \param spacing value of `boltSpacing` for this bolt. \param scale drawing units per metre.
std::vector<Mark> marksToDraw(const BoltShape& bolt, double spacing, double scale, const DetailSizes& sizes);

/// Order in which the key of a figure lists the kinds of marks.
inline constexpr std::array keyOrder{MarkKind::Bonded,   MarkKind::Artificial, MarkKind::Slipping,
                                     MarkKind::Gone,     MarkKind::Ruptured,   MarkKind::Yielded,
                                     MarkKind::InGap,    MarkKind::Plate,      MarkKind::PlateLost};

/// The kinds of marks that occur on any bolt, each listed once, in the order of the key.
/// \param marks for each bolt, the list of its marks.
std::vector<MarkKind> kindsOf(const std::vector<std::vector<Mark>>& marks);

/// Blocks that have moved far enough for their initial outlines to be drawn too. Empty if there are more than three
/// such blocks and they make up more than a tenth of all blocks. \param scale drawing units per metre.
std::vector<const BlockShape*> movedBlocks(const SectionPicture& picture, double scale, const DetailSizes& sizes);

}  // namespace keyblock
