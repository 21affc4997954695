// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/section_figure.h"

#include "solver/results/tables.h"
#include "ui/figure/column.h"
#include "ui/figure/map_ink.h"
#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double leastBeside = 115.0;  // narrower figures have the legends below the section [mm]
constexpr double lowest = 0.35, highest = 1.2;  // height of the section over its width

SectionRequest requestOf(const RunSource& run, const FigureRequest& request) {
    SectionRequest section;
    section.frame = frameAt(run, request.filter);
    section.blocks = findQuantity(blockQuantities(), "sigma1");
    section.bolts = findQuantity(boltQuantities(), "axial_force");
    section.ribbon = request.filter.bolt;
    section.factor = request.factor;
    section.whole = request.whole;
    if (!request.quantity) return section;
    if (const auto* ofBlocks = findQuantity(blockQuantities(), *request.quantity)) section.blocks = ofBlocks;
    else if (const auto* ofBolts = findQuantity(boltQuantities(), *request.quantity)) section.bolts = ofBolts;
    else
        throw CannotDraw("a section shows no quantity '" + *request.quantity + "'; of blocks there are " +
                         namesOf(blockQuantities()) + "; of bolts " + namesOf(boltQuantities()));
    return section;
}

/// Where the section and the items beside or below it stand.
class SectionLayout {
public:
    SectionLayout(const SectionPicture& picture, const Scene& scene, double width, double top, double inner)
        : inner_(inner), beside_(width >= leastBeside) {
        columnWidth_ = beside_ ? column : 0.5 * (inner - gutter);
        const double mapWidth = beside_ ? inner - gutter - column : inner;
        // The key depends on the marks, these on the scale, and the scale on the height that the items need.
        const Point extent = picture.window.max - picture.window.min;
        double height = mapWidth * std::clamp(extent.y() / extent.x(), lowest, highest);
        for (int pass = 0; pass < 2; ++pass) {
            map_ = {{margin, top}, {margin + mapWidth, top + height}};
            addItems(picture, scene);
            if (beside_) height = std::max(height, std::min(columnHeight(), highest * mapWidth));
        }
        place();
    }

    const Box& map() const { return map_; }
    double height() const { return height_; }  // of everything [mm]

    void drawItems(Ink& ink) const {
        for (std::size_t i = 0; i < items_.size(); ++i) items_[i].draw(ink, corners_[i]);
    }

private:
    void addItems(const SectionPicture& picture, const Scene& scene) {
        items_.clear();
        if (picture.blockLegend) items_.push_back(barItem(*picture.blockLegend, columnWidth_));
        if (picture.boltLegend) items_.push_back(barItem(*picture.boltLegend, columnWidth_));
        if (const auto kinds = MapInk(picture, map_).kinds(); !kinds.empty())
            items_.push_back(keyItem(kinds, columnWidth_));
        if (picture.blockLegend || !picture.events.entries.empty())
            items_.push_back(eventsItem(scene, picture.events, columnWidth_));
    }

    double columnHeight() const {
        double height = 0.0;
        for (const ColumnItem& item : items_) height += item.height + itemGap;
        return std::max(0.0, height - itemGap);
    }

    void place() {
        const double mapHeight = map_.max.y() - map_.min.y();
        if (beside_) {
            Point at(map_.max.x() + gutter, map_.min.y());
            for (const ColumnItem& item : items_) {
                corners_.push_back(at);
                at.y() += item.height + itemGap;
            }
            height_ = std::max(mapHeight, columnHeight());
            return;
        }
        std::array<double, 2> ends{map_.max.y() + itemGap, map_.max.y() + itemGap};
        for (const ColumnItem& item : items_) {
            const std::size_t side = ends[0] <= ends[1] ? 0 : 1;
            corners_.emplace_back(margin + static_cast<double>(side) * (columnWidth_ + gutter), ends[side]);
            ends[side] += item.height + itemGap;
        }
        height_ = items_.empty() ? mapHeight : std::max(ends[0], ends[1]) - itemGap - map_.min.y();
    }

    double inner_;
    bool beside_;
    double columnWidth_ = 0.0, height_ = 0.0;
    Box map_;
    std::vector<ColumnItem> items_;
    std::vector<Point> corners_;
};

std::vector<FigureData> dataOf(const RunSource& run, const SectionRequest& section) {
    if (!section.frame) return {};
    TableFilter filter;
    filter.stage = run.frames()[*section.frame].stage;
    filter.when = When::At;
    filter.time = run.frames()[*section.frame].time;
    const auto table = [&run](TableKind kind, const TableFilter& rows) {
        return [&run, kind, rows](std::ostream& out) { writeTable(kind, run, rows, out); };
    };
    std::vector<FigureData> data{{"-blocks", table(TableKind::Blocks, filter)}};
    if (!run.scene().bolts.empty()) data.push_back({"-bolts", table(TableKind::Bolts, filter)});
    data.push_back({"-events", table(TableKind::Events, {})});
    return data;
}

}  // namespace

Figure paintSection(const RunSource& run, const FigureRequest& request) {
    const SectionRequest section = requestOf(run, request);
    const SectionPicture picture = sectionPicture(run, section);
    const Sheet sheet(request.width, picture.title, picture.subtitle);
    const SectionLayout layout(picture, run.scene(), request.width, sheet.top(), sheet.inner());
    const double height = std::ceil(sheet.heightAround(layout.height()));
    Paper paper(request.format, request.width, height, request.dpi, picture.title);
    Ink ink(paper.painter());
    sheet.draw(ink, height, footOf(run, request, section.frame, height));
    MapInk(picture, layout.map()).draw(ink);
    layout.drawItems(ink);
    return {paper.finish(), dataOf(run, section)};
}

}  // namespace keyblock
