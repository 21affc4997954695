// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A place that a person pins: a point of a block, or a place along a bolt. It moves
// with what it is pinned to, and has a value in every frame.
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
    int number = 0;  // as it is called, from 1
    int block = -1;  // row of the solved blocks; −1: on a bolt
    std::array<std::pair<std::size_t, double>, 3> corners{};  // of the block, with their shares in the place
    int bolt = -1;  // row of the scene's bolts
    int element = -1, node = -1;  // of the bolt; the node is −1 where the place lies between two
    double s = 0.0;  // along the bolt from its far end [m]
    const FrameQuantity<BlockState>* ofBlock = nullptr;
    const FrameQuantity<BoltNodeFrame>* ofBolt = nullptr;
    std::string where;  // "Block 143", "B6 at 1.20 m"

    const QuantityDisplay& display() const { return ofBolt ? ofBolt->display : ofBlock->display; }
    bool operator==(const Pin&) const = default;
};

/// What lies at `place` [m], as drawn, with the quantity that is asked for. \pre a quantity of its kind is given.
Pin pinAt(const SectionPicture& picture, const Pick& pick, const Point& place, const FrameQuantity<BlockState>* ofBlock,
          const FrameQuantity<BoltNodeFrame>* ofBolt);

/// Where the pin is drawn [m]; nothing while its block or bolt is not there.
std::optional<Point> placeOf(const Pin& pin, const SectionPicture& picture);

/// Where it was at the start of the scene [m]. \pre it is on a block. \param before corners of the solved blocks.
Point placeBefore(const Pin& pin, const std::vector<std::vector<Point>>& before);

/// The values of a pin, frame by frame. Displacements are those of the point, not of the block's centre.
class PinTrack {
public:
    explicit PinTrack(Pin pin) : pin_(std::move(pin)) {}

    const Pin& pin() const { return pin_; }
    /// Frames must come in order.
    void add(const Frame& frame);
    std::size_t frames() const { return values_.size(); }
    /// In the unit shown; not a number where the block or bolt was not there.
    const std::vector<double>& values() const { return values_; }

private:
    double valueOf(const Frame& frame);
    double ofPoint(const BlockState& block);

    Pin pin_;
    std::vector<double> values_;
    std::optional<Point> reference_, centre_, last_;  // of its displacement; the block's; where it was [m]
};

/// The pins' curves over time, quantities of one kind in one panel of a chart, four curves at most.
std::vector<Chart> pinCharts(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks);

/// "1 Block 143"; the quantity with its unit.
std::string nameOf(const Pin& pin);
std::string titleOf(const Pin& pin);

}  // namespace keyblock
