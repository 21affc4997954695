// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/not_finite.h"

#include "solver/results/frame_quantities.h"
#include "ui/picture/ticks.h"

#include <algorithm>

namespace keyblock {

namespace {

bool isPlace(const Point& place) { return canBeShown(place.x()) && canBeShown(place.y()); }

template <typename Row>
bool haveValues(const Row& row, std::span<const FrameQuantity<Row>> quantities) {
    return std::ranges::all_of(quantities, [&](const auto& one) { return canBeShown(one.value(row)); });
}

std::string countText(long count, const std::string& what) {
    return count == 0 ? "" : std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

bool canBeDrawn(const BlockState& block) {
    return std::ranges::all_of(block.points, [](const Point& corner) { return isPlace(corner); });
}

bool canBeDrawn(const BoltFrame& bolt) {
    return std::ranges::all_of(bolt.nodes,
                               [](const BoltNodeFrame& node) { return isPlace(node.position) && canBeShown(node.s); });
}

std::string notFiniteText(const Frame& frame) {
    const auto blocks = std::ranges::count_if(frame.blocks, [](const BlockState& block) {
        return block.area != 0.0 && !(canBeDrawn(block) && haveValues(block, blockQuantities()));
    });
    const auto bolts = std::ranges::count_if(frame.bolts, [](const BoltFrame& bolt) {
        return !canBeDrawn(bolt) || !std::ranges::all_of(bolt.nodes, [](const BoltNodeFrame& node) {
            return haveValues(node, boltQuantities());
        });
    });
    if (blocks + bolts == 0) return {};
    const std::string both = blocks > 0 && bolts > 0 ? " and " : "";
    return "values of " + countText(blocks, "block") + both + countText(bolts, "bolt") +
           " are not finite, or larger than 1e100, and are not shown";
}

}  // namespace keyblock
