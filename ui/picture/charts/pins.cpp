// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/charts/pins.h"

#include "ui/picture/charts/series_chart.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

constexpr double sameCentre = 1e-7;  // [m] if the initial centroid changes by more, displacements have restarted
constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

double twiceArea(const Point& a, const Point& b, const Point& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Barycentric coordinates with respect to three corners that are far apart. They stay the same while the block moves,
/// because it deforms by an affine map.
std::array<std::pair<std::size_t, double>, 3> sharesOf(const std::vector<Point>& corners, const Point& place) {
    std::size_t second = 1, third = 2;
    const auto away = [&](std::size_t i) { return (corners[i] - corners[0]).norm(); };
    const auto area = [&](std::size_t i) { return std::abs(twiceArea(corners[0], corners[second], corners[i])); };
    for (std::size_t i = 1; i < corners.size(); ++i)
        if (away(i) > away(second)) second = i;
    third = second == 1 ? 2 : 1;
    for (std::size_t i = 1; i < corners.size(); ++i)
        if (area(i) > area(third)) third = i;
    const double whole = twiceArea(corners[0], corners[second], corners[third]);
    if (whole == 0.0) return {{{0, 1.0}, {second, 0.0}, {third, 0.0}}};
    const double b = twiceArea(corners[0], place, corners[third]) / whole;
    const double c = twiceArea(corners[0], corners[second], place) / whole;
    return {{{0, 1.0 - b - c}, {second, b}, {third, c}}};
}

std::optional<Point> placeWithin(const Pin& pin, const std::vector<Point>& corners) {
    Point place(0.0, 0.0);
    for (const auto& [corner, share] : pin.corners) {
        if (corner >= corners.size()) return std::nullopt;
        place += share * corners[corner];
    }
    return place;
}

/// Index of the node row with the pinned value: steel forces belong to elements, bond values to nodes.
std::size_t rowOf(const Pin& pin) {
    const bool ofElement = rowOf(*pin.ofBolt).part == BoltPart::Element;
    return ofElement || pin.node < 0 ? pin.element : pin.node;
}

}  // namespace

Pin pinAt(const SectionPicture& picture, const Pick& pick, const Point& place, const FrameQuantity<BlockState>* ofBlock,
          const FrameQuantity<BoltNodeFrame>* ofBolt) {
    assert(pick.kind == PickKind::Block ? ofBlock != nullptr : ofBolt != nullptr);
    Pin pin;
    if (pick.kind == PickKind::Block) {
        const BlockShape& block = picture.blocks[pick.shape];
        pin.block = block.block;
        pin.corners = sharesOf(block.outline, place);
        pin.ofBlock = ofBlock;
        pin.where = "Block " + block.name;
        return pin;
    }
    const BoltShape& bolt = picture.bolts[pick.shape];
    pin.bolt = bolt.bolt;
    pin.element = pick.element;
    pin.node = pick.node;
    pin.ofBolt = ofBolt;
    const std::size_t e = pick.element;
    pin.s = pick.node >= 0 ? bolt.s[pick.node] : 0.5 * (bolt.s[e] + bolt.s[e + 1]);
    pin.where = bolt.name + " at " + numberText(pin.s, 2) + " m";
    return pin;
}

std::optional<Point> placeOf(const Pin& pin, const SectionPicture& picture) {
    for (const BlockShape& block : picture.blocks)
        if (pin.block >= 0 && block.block == pin.block) return placeWithin(pin, block.outline);
    for (const BoltShape& bolt : picture.bolts) {
        if (pin.bolt < 0 || bolt.bolt != pin.bolt) continue;
        const auto e = static_cast<std::size_t>(pin.element), n = static_cast<std::size_t>(std::max(pin.node, 0));
        if (pin.node >= 0 && n < bolt.nodes.size()) return bolt.nodes[n];
        if (e + 1 < bolt.nodes.size()) return Point(0.5 * (bolt.nodes[e] + bolt.nodes[e + 1]));
    }
    return std::nullopt;
}

Point placeBefore(const Pin& pin, const std::vector<std::vector<Point>>& before) {
    assert(pin.block >= 0);
    return placeWithin(pin, before.at(static_cast<std::size_t>(pin.block))).value_or(Point(0.0, 0.0));
}

void PinTrack::add(const Frame& frame) { values_.push_back(valueOf(frame)); }

double PinTrack::valueOf(const Frame& frame) {
    if (pin_.ofBolt) {
        const std::size_t bolt = pin_.bolt;
        if (bolt >= frame.bolts.size() || rowOf(pin_) >= frame.bolts[bolt].nodes.size()) return noNumber;
        return pin_.ofBolt->value(frame.bolts[bolt].nodes[rowOf(pin_)]) * pin_.ofBolt->display.factor;
    }
    const std::size_t block = pin_.block;
    if (block >= frame.blocks.size() || frame.blocks[block].area == 0.0) return noNumber;
    return ofPoint(frame.blocks[block]) * pin_.ofBlock->display.factor;
}

/// If the displacements of blocks restart from zero, that of the point does so too, from its position at that time.
double PinTrack::ofPoint(const BlockState& block) {
    const std::optional<Point> place = placeWithin(pin_, block.points);
    if (!place) return noNumber;
    const Point centre = block.centroid - block.displacement;
    if (!centre_) reference_ = *place - block.displacement;
    else if ((centre - *centre_).norm() > sameCentre) reference_ = last_;
    centre_ = centre;
    last_ = place;
    const Point moved = *place - *reference_;
    if (pin_.ofBlock->name == "ux") return moved.x();
    if (pin_.ofBlock->name == "uy") return moved.y();
    if (pin_.ofBlock->name == "displacement") return moved.norm();
    return pin_.ofBlock->value(block);
}

std::string titleOf(const Pin& pin) {
    const QuantityDisplay& display = pin.display();
    return std::string(display.title) + (display.unit.empty() ? "" : " (" + std::string(display.unit) + ")");
}

std::string nameOf(const Pin& pin) { return std::to_string(pin.number) + " " + pin.where; }

std::vector<Chart> pinCharts(const RunSource& run, const std::vector<std::shared_ptr<const PinTrack>>& tracks) {
    const RunTime time(run);
    std::vector<double> times;
    for (const FrameHead& frame : run.frames()) times.push_back(time.at(frame.stage, frame.time));
    std::vector<Chart> charts;
    std::vector<std::size_t> counts;
    for (const auto& track : tracks) {
        const std::string title = titleOf(track->pin());
        std::size_t at = 0;
        while (at < charts.size() && (charts[at].panels.front().title != title || counts[at] == mostCurves)) ++at;
        if (at == charts.size()) {
            charts.push_back(chartOverTime(time, run.events()));
            charts.back().panels.emplace_back().title = title;
            charts.back().panels.back().note = std::string(track->pin().display().convention);
            counts.push_back(0);
        }
        std::vector<double> values = track->values();
        values.resize(std::min(values.size(), times.size()));
        addCurve(charts[at].panels.front(), curveStyles[counts[at]++], nameOf(track->pin()), times, values);
    }
    std::erase_if(charts, [](Chart& chart) { return chart.panels.front().curves.empty() || !finishChart(chart); });
    return charts;
}

}  // namespace keyblock
