// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/section_layout.h"

#include "ui/figure/contact_painter.h"
#include "ui/figure/map_painter.h"

#include <algorithm>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double leastBeside = 115.0;  // [mm] narrower figures have the legends below the section
constexpr double lowest = 0.35, highest = 1.2;  // limits of the section's height relative to its width

}  // namespace

SectionLayout::SectionLayout(const SectionPicture& picture, const Scene& scene, double width, double top, double inner,
                             std::optional<std::vector<MarkKind>> kinds)
    : inner_(inner), beside_(width >= leastBeside) {
    columnWidth_ = beside_ ? column : 0.5 * (inner - gutter);
    const double mapWidth = beside_ ? inner - gutter - column : inner;
    // Done twice, because the key depends on the marks, the marks on the scale, and the scale on the height of all
    // items.
    const Point extent = picture.window.max - picture.window.min;
    double height = mapWidth * std::clamp(extent.y() / extent.x(), lowest, highest);
    Items items;
    for (int pass = 0; pass < 2; ++pass) {
        map_ = {{margin, top}, {margin + mapWidth, top + height}};
        kinds_ = kinds ? *kinds : MapPainter(picture, map_).kinds();
        items = itemsOf(picture, scene);
        if (beside_) height = std::max(height, std::min(columnHeight(items), highest * mapWidth));
    }
    place(items);
}

SectionLayout::Items SectionLayout::itemsOf(const SectionPicture& picture, const Scene& scene) const {
    Items items;
    if (picture.blockLegend) items[0] = barItem(*picture.blockLegend, columnWidth_);
    if (picture.arrows && picture.arrows->largest > 0.0)  // instead of colours
        items[0] = arrowItem(*picture.arrows, arrowScale(*picture.arrows), columnWidth_);
    if (picture.contacts)
        items[0] = contactItem(*picture.contacts, MapPainter(picture, map_).longestContact(), columnWidth_);
    if (picture.boltLegend) items[1] = barItem(*picture.boltLegend, columnWidth_);
    if (!kinds_.empty()) items[2] = keyItem(kinds_, columnWidth_);
    if (picture.blockLegend || picture.arrows || picture.contacts || !picture.events.entries.empty())
        items[3] = eventsItem(scene, picture.events, columnWidth_);
    return items;
}

double SectionLayout::columnHeight(const Items& items) {
    double height = 0.0;
    for (const auto& item : items)
        if (item) height += item->height + itemGap;
    return std::max(0.0, height - itemGap);
}

void SectionLayout::place(const Items& items) {
    const double mapHeight = map_.max.y() - map_.min.y();
    if (beside_) {
        Point at(map_.max.x() + gutter, map_.min.y());
        for (std::size_t i = 0; i < items.size(); ++i) {
            corners_[i] = at;
            if (items[i]) at.y() += items[i]->height + itemGap;
        }
        height_ = std::max(mapHeight, columnHeight(items));
        return;
    }
    std::array<double, 2> ends{map_.max.y() + itemGap, map_.max.y() + itemGap};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::size_t side = ends[0] <= ends[1] ? 0 : 1;
        corners_[i] = {margin + static_cast<double>(side) * (columnWidth_ + gutter), ends[side]};
        if (items[i]) ends[side] += items[i]->height + itemGap;
    }
    const bool none = std::none_of(items.begin(), items.end(), [](const auto& item) { return item.has_value(); });
    height_ = none ? mapHeight : std::max(ends[0], ends[1]) - itemGap - map_.min.y();
}

void SectionLayout::draw(Ink& ink, const SectionPicture& picture, const Scene& scene) const {
    MapPainter(picture, map_).draw(ink);
    const Items items = itemsOf(picture, scene);
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i]) items[i]->draw(ink, corners_[i]);
}

}  // namespace keyblock
