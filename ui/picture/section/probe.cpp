// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/probe.h"

#include "solver/results/result_names.h"
#include "ui/picture/section/shown_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 4> ofBlocks{"sigma1", "sigma3", "displacement", "velocity"};

constexpr double peakBeyond = 0.01;  // relative difference above which the peak is shown next to the current value

/// Creates rows in the units and sign conventions of a picture.
struct RowMaker {
    const ShownNumbers& numbers;
    ProbeReading& reading;

    std::string shown(double value, const QuantityDisplay& display, bool hasUnit) const {
        const ShownAs as = shownAs(display.unit, display.convention, numbers);
        const std::string text = numberText(as.factor * withoutRoundOff(value * display.factor, display.unit));
        return !hasUnit || as.unit.empty() ? text : text + " " + as.unit;
    }

    template <typename Row>
    void add(const FrameQuantity<Row>& quantity, const Row& row, const BlockExtremes* extremes) {
        constexpr std::string_view stress = "Block stress ";
        std::string title(quantity.display.title);
        if (title.starts_with(stress)) title.erase(0, stress.size());
        const double now = quantity.value(row);
        std::string text = shown(now, quantity.display, true);
        const BlockPeak* peak = extremes ? peakOf(*extremes, quantity.name) : nullptr;
        if (peak && std::abs(peak->value - now) > peakBeyond * std::abs(peak->value))
            text += ", peak " + shown(peak->value, quantity.display, false);
        reading.rows.emplace_back(title, text);
    }

    void addBlock(const FrameQuantity<BlockState>* first, const BlockState& block, const BlockExtremes* extremes) {
        if (first) add(*first, block, extremes);
        for (const std::string_view name : ofBlocks)
            if (const auto* quantity = findQuantity(blockQuantities(), name); quantity && quantity != first)
                add(*quantity, block, extremes);
    }

    void addNode(const FrameQuantity<BoltNodeFrame>* first, const BoltNodeFrame& node) {
        if (first) add(*first, node, nullptr);
        for (const FrameQuantity<BoltNodeFrame>& quantity : boltQuantities())
            if (&quantity != first) add(quantity, node, nullptr);
    }
};

}  // namespace

ProbeReading probed(const SectionPicture& picture, const Frame& frame, const Pick& pick,
                    const FrameQuantity<BlockState>* blocksFirst, const FrameQuantity<BoltNodeFrame>* boltsFirst) {
    ProbeReading reading;
    RowMaker make{picture.numbers, reading};
    if (pick.kind == PickKind::Block) {
        reading.head = "Block " + picture.blocks[pick.shape].name;
        const std::size_t block = pick.block;
        if (block < frame.blocks.size())
            make.addBlock(blocksFirst, frame.blocks[block],
                          block < frame.blockExtremes.size() ? &frame.blockExtremes[block] : nullptr);
        return reading;
    }
    const BoltShape& shape = picture.bolts[pick.shape];
    const std::size_t bolt = pick.bolt;
    const std::size_t at = pick.node >= 0 ? pick.node : pick.element;
    reading.head = shape.name + " at " + numberText(at < shape.s.size() ? shape.s[at] : 0.0, 2) + " m";
    if (bolt >= frame.bolts.size() || at >= frame.bolts[bolt].nodes.size()) return reading;
    BoltNodeFrame node = frame.bolts[bolt].nodes[at];
    // Steel forces belong to the element; those in the row of the head are the forces of the face plate.
    const BoltNodeFrame& element = frame.bolts[bolt].nodes[std::max(pick.element, 0)];
    node.axialForce = element.axialForce;
    node.shearForce = element.shearForce;
    make.addNode(boltsFirst, node);
    if (pick.node >= 0) reading.rows.emplace_back("Bond", std::string(wordOf(node.state)));
    return reading;
}

}  // namespace keyblock
