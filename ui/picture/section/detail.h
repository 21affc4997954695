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

/// Unit vector from the first node to the last; the x direction if they coincide.
Point alongOf(const std::vector<Point>& nodes);

/// True if the ends of two bolts are within `apart` [m] of each other, so that the bolts cannot be drawn separately.
bool coincide(const BoltShape& a, const BoltShape& b, double apart);

/// Distance from the head of each bolt to the nearest other bolt, in drawing units; a very large number if there is no
/// other bolt. Coinciding bolts are ignored. \param scale drawing units per metre.
std::vector<double> boltSpacing(const SectionPicture& picture, double scale, const DetailSizes& sizes);

/// Distance from the midpoint of a bolt to the nearest other bolt [m]; 1e9 if there is none. Bolts that coincide within
/// `apart` [m] are ignored. \param shape index of the bolt in the picture.
double middleSpacing(const SectionPicture& picture, std::size_t shape, double apart);

/// The marks that are drawn on a bolt, with the most important ones last. \param spacing value from `boltSpacing` for
/// this bolt.
std::vector<Mark> marksToDraw(const BoltShape& bolt, double spacing, double scale, const DetailSizes& sizes);

/// Order of the marks in the key of a figure.
inline constexpr std::array keyOrder{MarkKind::Bonded,   MarkKind::Artificial, MarkKind::Slipping,
                                     MarkKind::Gone,     MarkKind::Ruptured,   MarkKind::Yielded,
                                     MarkKind::InGap,    MarkKind::Plate,      MarkKind::PlateLost};

/// The kinds that occur among the marks of all bolts, each once, in the order of the key.
std::vector<MarkKind> kindsOf(const std::vector<std::vector<Mark>>& marks);

/// Blocks that have moved far enough for their initial outline to be drawn too. Empty if there are more than three such
/// blocks and they make up more than a tenth of all blocks.
std::vector<const BlockShape*> movedBlocks(const SectionPicture& picture, double scale, const DetailSizes& sizes);

}  // namespace keyblock
