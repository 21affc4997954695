// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/detail.h"

#include "geometry/segment.h"

#include <algorithm>

namespace keyblock {

bool isArtificial(MarkKind kind) { return kind == MarkKind::Artificial || kind == MarkKind::InGap; }

Point alongOf(const std::vector<Point>& nodes) {
    const Point along = nodes.back() - nodes.front();
    return along.norm() > 0.0 ? Point(along.normalized()) : Point(1.0, 0.0);
}

bool coincide(const BoltShape& a, const BoltShape& b, double apart) {
    const auto near = [&](const Point& p, const Point& q) { return (p - q).norm() <= apart; };
    return (near(a.nodes.front(), b.nodes.front()) && near(a.nodes.back(), b.nodes.back())) ||
           (near(a.nodes.front(), b.nodes.back()) && near(a.nodes.back(), b.nodes.front()));
}

std::vector<double> boltSpacing(const SectionPicture& picture, double scale, const DetailSizes& sizes) {
    std::vector<double> spacing;
    for (const BoltShape& bolt : picture.bolts) {
        double nearest = 1e9;
        for (const BoltShape& other : picture.bolts)
            if (&other != &bolt && !coincide(bolt, other, 0.5 * sizes.shank / scale))
                nearest = std::min(nearest, distanceToSegment(other.nodes.front(), other.nodes.back(),
                                                              bolt.nodes.back()));
        spacing.push_back(nearest * scale);
    }
    return spacing;
}

double middleSpacing(const SectionPicture& picture, std::size_t shape, double apart) {
    const BoltShape& bolt = picture.bolts[shape];
    const Point middle = 0.5 * (bolt.nodes.front() + bolt.nodes.back());
    double nearest = 1e9;
    for (const BoltShape& other : picture.bolts)
        if (&other != &bolt && !coincide(bolt, other, apart))
            nearest = std::min(nearest, distanceToSegment(other.nodes.front(), other.nodes.back(), middle));
    return nearest;
}

/// If bolts are crowded or short, or the scale is small, there is space only for the marks of failures.
std::vector<Mark> marksToDraw(const BoltShape& bolt, double spacing, double scale, const DetailSizes& sizes) {
    std::vector<Mark> marks = bolt.marks;
    const double length = (bolt.nodes.back() - bolt.nodes.front()).norm() * scale;
    const bool noRoom = length < sizes.boltForMarks || spacing < sizes.spacingForMarks;
    std::erase_if(marks, [&](const Mark& mark) {
        if (mark.kind == MarkKind::Plate) return spacing < sizes.spacingForPlates;
        if (isArtificial(mark.kind)) return noRoom || scale < sizes.scaleForArtificial;
        return noRoom && mark.kind == MarkKind::Bonded;
    });
    return thinned(std::move(marks), sizes.betweenMarks / scale);
}

std::vector<MarkKind> kindsOf(const std::vector<std::vector<Mark>>& marks) {
    std::vector<MarkKind> found;
    for (const MarkKind kind : keyOrder)
        if (std::any_of(marks.begin(), marks.end(), [&](const auto& ofBolt) {
                return std::any_of(ofBolt.begin(), ofBolt.end(), [&](const Mark& m) { return m.kind == kind; });
            }))
            found.push_back(kind);
    return found;
}

std::vector<const BlockShape*> movedBlocks(const SectionPicture& picture, double scale, const DetailSizes& sizes) {
    std::vector<const BlockShape*> moved;
    for (const BlockShape& block : picture.blocks)
        if (block.displaced * scale > sizes.moved) moved.push_back(&block);
    if (moved.size() > std::max<std::size_t>(3, picture.blocks.size() / 10)) moved.clear();
    return moved;
}

}  // namespace keyblock
