// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point pinned by the user: a point of a block, or a position along a bolt. It moves
// with the block or bolt, and has a value in every frame.
#pragma once

#include "ui/picture/chart.h"
#include "ui/picture/pick.h"
#include "ui/picture/run_time.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

struct Pin {
    int number = 0;  // its label, from 1
    int block = -1;  // row of the solved blocks; −1: on a bolt
    std::array<std::pair<std::size_t, double>, 3> corners{};  // of the block, with the barycentric coordinates of the point
    int bolt = -1;  // row of the scene's bolts
    int element = -1, node = -1;  // of the bolt; the node is −1 if the point is between two
    double s = 0.0;  // along the bolt from its far end [m]
    const FrameQuantity<BlockState>* ofBlock = nullptr;
    const FrameQuantity<BoltNodeFrame>* ofBolt = nullptr;
    std::string where;  // "Block 143", "B6 at 1.20 m"

    const QuantityDisplay& display() const { return ofBolt ? ofBolt->display : ofBlock->display; }
    bool operator==(const Pin&) const = default;
};

/// A pin of the object at `place` [m], as drawn, with the quantity requested. \pre a quantity of its kind is given.
Pin pinAt(const SectionPicture& picture, const Pick& pick, const Point& place, const FrameQuantity<BlockState>* ofBlock,
          const FrameQuantity<BoltNodeFrame>* ofBolt);

/// Position of the pin as drawn [m]; none while its block or bolt does not exist.
std::optional<Point> placeOf(const Pin& pin, const SectionPicture& picture);

/// Its position at the start of the scene [m]. \pre it is on a block. \param before corners of the solved blocks.
Point placeBefore(const Pin& pin, const std::vector<std::vector<Point>>& before);

/// The values of a pin, frame by frame. Displacements are those of the point, not of the block's centre.
class PinTrack {
public:
    explicit PinTrack(Pin pin) : pin_(std::move(pin)) {}

    const Pin& pin() const { return pin_; }
    /// Frames must come in order.
    void add(const Frame& frame);
    std::size_t frames() const { return values_.size(); }
    /// In the unit shown; NaN if the block or bolt did not exist.
    const std::vector<double>& values() const { return values_; }

private:
    double valueOf(const Frame& frame);
    double ofPoint(const BlockState& block);

    Pin pin_;
    std::vector<double> values_;
    std::optional<Point> reference_, centre_, last_;  // of the point's displacement; the block's; position then [m]
};

/// The pins' curves over time, one panel per quantity, four curves at most.
std::vector<Chart> pinCharts(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks);

/// "1 Block 143"; the quantity with its unit.
std::string nameOf(const Pin& pin);
std::string titleOf(const Pin& pin);

}  // namespace keyblock
