// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point pinned by the user: a point of a block, or a position along a bolt. It moves
// with the block or bolt, and its value can be read in every frame.
#pragma once

#include "ui/picture/chart.h"
#include "ui/picture/run_time.h"
#include "ui/picture/section/pick.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

struct Pin {
    int number = 0;  // shown on the pin, counted from 1
    int block = -1;  // row of the solved blocks; −1: on a bolt
    std::array<std::pair<std::size_t, double>, 3> corners{};  // corner of the block, barycentric weight
    int bolt = -1;  // row of the scene's bolts
    int element = -1, node = -1;  // of the bolt; node is −1 if the point lies between two nodes
    double s = 0.0;  // distance along the bolt from its far end [m]
    const FrameQuantity<BlockState>* ofBlock = nullptr;
    const FrameQuantity<BoltNodeFrame>* ofBolt = nullptr;
    std::string where;  // "Block 143", "B6 at 1.20 m"

    const QuantityDisplay& display() const { return ofBolt ? ofBolt->display : ofBlock->display; }
    bool operator==(const Pin&) const = default;
};

/// Creates a pin on the picked object at `place` [m, as drawn].
/// \param ofBlock quantity read at a pin on a block. \param ofBolt quantity read at a pin on a bolt.
/// \pre `ofBlock` is not null if a block was picked; otherwise `ofBolt` is not null.
Pin pinAt(const SectionPicture& picture, const Pick& pick, const Point& place, const FrameQuantity<BlockState>* ofBlock,
          const FrameQuantity<BoltNodeFrame>* ofBolt);

/// Position of a pin as drawn in `picture` [m]; null if the picture does not contain the pin's block or bolt.
std::optional<Point> placeOf(const Pin& pin, const SectionPicture& picture);

/// Position of a pin at the start of the run [m]. \param before initial corners of the solved blocks, from
/// `cornersBefore`. \pre the pin is on a block.
Point placeBefore(const Pin& pin, const std::vector<std::vector<Point>>& before);

/// Values of a pin, one for each frame. A displacement is that of the pinned point, not of the block's centroid.
class PinTrack {
public:
    explicit PinTrack(Pin pin) : pin_(std::move(pin)) {}

    const Pin& pin() const { return pin_; }
    /// Appends the value of the pin in this frame. \pre frames are added in chronological order.
    void add(const Frame& frame);
    std::size_t frames() const { return values_.size(); }
    /// One value per frame added, in the display unit; NaN if the block or bolt does not exist in that frame.
    const std::vector<double>& values() const { return values_; }

private:
    double valueOf(const Frame& frame);
    double ofPoint(const BlockState& block);

    Pin pin_;
    std::vector<double> values_;
    std::optional<Point> reference_, centre_, last_;  // [m] origin of displacements; initial centroid; last position
};

/// Charts of the pinned values over time, with one panel per quantity and at most four curves each.
std::vector<Chart> pinCharts(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks);

/// `nameOf`: name of a pin, such as "1 Block 143". `titleOf`: title of the pinned quantity, with the unit.
std::string nameOf(const Pin& pin);
std::string titleOf(const Pin& pin);

}  // namespace keyblock
