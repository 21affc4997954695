// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/probe.h"

#include "solver/results/words.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 4> ofBlocks{"sigma1", "sigma3", "displacement", "velocity"};
constexpr std::array<std::string_view, 5> ofBolts{"axial_force", "shear_force", "moment", "anchor_force", "slip"};

template <typename Row>
void addRow(ProbeReading& reading, const FrameQuantity<Row>& quantity, const Row& row) {
    constexpr std::string_view stress = "Block stress ";
    std::string title(quantity.display.title);
    if (title.starts_with(stress)) title.erase(0, stress.size());
    const std::string value = numberText(quantity.value(row) * quantity.display.factor);
    reading.rows.emplace_back(title, value + (quantity.display.unit.empty() ? "" : " ") + std::string(quantity.display.unit));
}

template <typename Row, std::size_t count>
void addRows(ProbeReading& reading, std::span<const FrameQuantity<Row>> all, const FrameQuantity<Row>* first,
             const std::array<std::string_view, count>& usual, const Row& row) {
    if (first) addRow(reading, *first, row);
    for (const std::string_view name : usual)
        if (const auto* quantity = findQuantity(all, name); quantity && quantity != first) addRow(reading, *quantity, row);
}

}  // namespace

ProbeReading probed(const SectionPicture& picture, const Frame& frame, const Pick& pick,
                    const FrameQuantity<BlockState>* blocksFirst, const FrameQuantity<BoltNodeFrame>* boltsFirst) {
    ProbeReading reading;
    if (pick.kind == PickKind::Block) {
        reading.head = "Block " + picture.blocks[pick.shape].name;
        if (static_cast<std::size_t>(pick.block) < frame.blocks.size())
            addRows(reading, blockQuantities(), blocksFirst, ofBlocks, frame.blocks[static_cast<std::size_t>(pick.block)]);
        return reading;
    }
    const BoltShape& shape = picture.bolts[pick.shape];
    const auto bolt = static_cast<std::size_t>(pick.bolt);
    const auto at = static_cast<std::size_t>(pick.node >= 0 ? pick.node : pick.element);
    reading.head = shape.name + " at " + numberText(at < shape.s.size() ? shape.s[at] : 0.0, 2) + " m";
    if (bolt >= frame.bolts.size() || at >= frame.bolts[bolt].nodes.size()) return reading;
    BoltNodeFrame node = frame.bolts[bolt].nodes[at];
    // Steel is told of the element; at the head the last row's forces are the plate's.
    const BoltNodeFrame& element = frame.bolts[bolt].nodes[static_cast<std::size_t>(std::max(pick.element, 0))];
    node.axialForce = element.axialForce;
    node.shearForce = element.shearForce;
    addRows(reading, boltQuantities(), boltsFirst, ofBolts, node);
    if (pick.node >= 0) reading.rows.emplace_back("Bond", std::string(wordOf(node.state)));
    return reading;
}

}  // namespace keyblock
