// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/pick.h"

#include "geometry/segment.h"

#include <ranges>
#include <utility>

namespace keyblock {

namespace {

std::vector<Box> boxesOf(const std::vector<BlockShape>& blocks) {
    std::vector<Box> boxes;
    for (const BlockShape& block : blocks) boxes.push_back(boxOf(block.outline));
    return boxes;
}

std::vector<Box> boxesOf(const std::vector<BoltShape>& bolts) {
    std::vector<Box> boxes;
    for (const BoltShape& bolt : bolts) boxes.push_back(boxOf(bolt.nodes));
    return boxes;
}

}  // namespace

PickIndex::PickIndex(std::shared_ptr<const SectionPicture> picture)
    : picture_(std::move(picture)), blocks_(boxesOf(picture_->blocks)), bolts_(boxesOf(picture_->bolts)) {}

std::optional<Pick> PickIndex::at(const Point& place, double reach) const {
    if (!place.allFinite()) return std::nullopt;
    const std::optional<Pick> block = blockAt(place);
    std::optional<Pick> bolt = boltAt(place, reach);
    if (bolt && block) bolt->block = block->block;
    return bolt ? bolt : block;
}

std::optional<Pick> PickIndex::boltAt(const Point& place, double reach) const {
    std::optional<Pick> found;
    double nearest = reach, nearestNode = reach;
    for (const int index : bolts_.meeting(grown({place, place}, reach))) {
        const BoltShape& bolt = picture_->bolts[index];
        const Pick pick{PickKind::Bolt, -1, bolt.bolt, -1, -1, static_cast<std::size_t>(index)};
        for (std::size_t e = 0; e + 1 < bolt.nodes.size(); ++e) {
            const double away = distanceToSegment(bolt.nodes[e], bolt.nodes[e + 1], place);
            if (away > nearest) continue;
            if (!found || found->bolt != bolt.bolt) nearestNode = reach;
            nearest = away;
            found = pick;
            found->element = static_cast<int>(e);
        }
        if (!found || found->shape != pick.shape || bolt.marks.empty()) continue;
        for (std::size_t n = 0; n < bolt.nodes.size(); ++n)
            if (const double away = (bolt.nodes[n] - place).norm(); away <= nearestNode) {
                nearestNode = away;
                found->kind = PickKind::Node;
                found->node = static_cast<int>(n);
            }
    }
    return found;
}

std::optional<Pick> PickIndex::blockAt(const Point& place) const {
    const std::vector<int> near = blocks_.meeting({place, place});
    for (const int index : near | std::views::reverse) {
        const BlockShape& block = picture_->blocks[index];
        if (locate(block.outline, place, 0.0) != Side::Outside)
            return Pick{PickKind::Block, block.block, -1, -1, -1, static_cast<std::size_t>(index)};
    }
    return std::nullopt;
}

}  // namespace keyblock
