// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The call-outs of a section: severe events, displaced blocks, the marked block, and
// the force diagram with its largest value and the limit next to it.
#include "solver/scene/units.h"
#include "ui/canvas/section_painter.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/picture/section/detail.h"
#include "ui/picture/ticks.h"
#include "ui/view/screen_sizes.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr std::size_t mostEvents = 6, mostMoved = 3;
constexpr double ribbonGap = 8.0, pixelsPerKn = 0.195, leastRoom = 9.0, usualRoom = 45.0;  // [px]
constexpr double hatchEach = 0.1;  // [m]
constexpr double leastForce = 50.0;  // [N] smallest force shown

struct CallOutTexts {
    Q_DECLARE_TR_FUNCTIONS(SectionPainter)
};

QPolygonF polygonOf(const std::vector<Point>& points) {
    QPolygonF polygon;
    for (const Point& point : points) polygon << QPointF(point.x(), point.y());
    return polygon;
}

/// Draws as many lines across the band as fit.
void hatch(QPainter& painter, const RibbonShape& shape, const std::vector<double>& s, double scale) {
    const double each = std::max(hatchEach, 4.0 / scale);
    double next = s.front() + each;
    for (std::size_t e = 0; e + 1 < s.size(); ++e)
        for (; next < s[e + 1]; next += each) {
            const double share = (next - s[e]) / (s[e + 1] - s[e]);
            const Point along = share * (shape.base[e + 1] - shape.base[e]);
            const Point foot = shape.base[e] + along, tip = shape.outline[2 * e + 1] + along;
            painter.drawLine(QPointF(foot.x(), foot.y()), QPointF(tip.x(), tip.y()));
        }
}

}  // namespace

void SectionPainter::paintRibbon(QPainter& painter) {
    if (!picture_.ribbon || !picture_.boltLegend) return;
    const Ribbon& ribbon = *picture_.ribbon;
    const BoltShape& bolt = picture_.bolts[ribbon.shape];
    const double scale = map_.pixelsPerMetre();
    const double nearest = scale * middleSpacing(picture_, ribbon.shape, 0.5 * shankOnScreen / scale);
    const std::string unit = ribbonUnit(*picture_.boltLegend);
    const double kilonewtons = unit == "kN" ? ribbon.scale : unit == "N" ? perSi(namedUnit("kN")) * ribbon.scale : 0.0;
    const double wished = std::max(usualRoom, pixelsPerKn * kilonewtons);
    const double room = std::min({wished, 0.4 * nearest, 0.35 * map_.size().height()});
    if (room < leastRoom) return;
    const RibbonShape shape = ribbonShape(ribbon, bolt.values, sheetPoints(bolt.nodes), ribbonGap, room);
    QColor fill = theme_.accent;
    fill.setAlphaF(0.2);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(polygonOf(shape.outline));
    painter.setPen(QPen(theme_.accent, 0.8));
    hatch(painter, shape, bolt.s, scale);
    painter.drawPolyline(polygonOf(shape.base));
    painter.setPen(QPen(theme_.accent, 1.5));
    painter.drawPolyline(polygonOf(shape.outline));
    QPen limit(theme_.error, 1.3);
    limit.setDashPattern({4.6, 2.3});
    painter.setPen(limit);
    for (const std::vector<Point>& line : shape.limits) {
        painter.drawPolyline(polygonOf(line));
        for (std::size_t i = 0; i + 1 < line.size(); ++i) placement_.keepOff(line[i], line[i + 1], 2.0);
    }
    painter.setPen(QPen(theme_.markCasing, 1.0));
    painter.setBrush(theme_.accent);
    painter.drawEllipse(QPointF(shape.peak.x(), shape.peak.y()), 3.0, 3.0);
    for (std::size_t e = 0; e < shape.tips.size(); ++e) placement_.keepOff(shape.feet[e], shape.tips[e], 3.0);
    callOutRibbon(shape);
}

void SectionPainter::callOutRibbon(const RibbonShape& shape) {
    const Ribbon& ribbon = *picture_.ribbon;
    const double value = picture_.bolts[ribbon.shape].values[ribbon.peak];
    const QString unit = ' ' + qt(ribbonUnit(*picture_.boltLegend));
    CallOut peak;
    peak.head = qt(picture_.bolts[ribbon.shape].name) + "  " + qt(numberText(value)) + unit;
    if (ribbon.limit)
        peak.detail = CallOutTexts::tr("%1 % of %2 strength")
                          .arg(std::lround(100.0 * std::abs(value) / *ribbon.limit))
                          .arg(qt(ribbon.limitName));
    peak.edge = theme_.accent;
    peak.at = shape.peak;
    peak.first = shape.across;
    callOuts_.push_back(peak);
    if (!ribbon.limit) return;
    CallOut limit;
    limit.head = qt(ribbon.limitName) + ' ' + qt(numberText(*ribbon.limit)) + unit;
    limit.head[0] = limit.head[0].toUpper();
    limit.edge = theme_.error;
    limit.at = shape.limitFrom;
    limit.first = shape.across;
    callOuts_.push_back(limit);
}

/// Adds call-outs of the marked block and then of the newest failures.
void SectionPainter::callOutEvents() {
    for (const BlockShape& block : picture_.blocks)
        if (highlighted_ && block.block == highlighted_->block)
            callOuts_.push_back({highlighted_->head, highlighted_->detail, theme_.warningFill,
                                 footWithin(sheetPoints(block.outline)), {-1.0, 0.5}, true});
    std::size_t added = 0;
    const auto& entries = picture_.events.entries;
    for (auto entry = entries.rbegin(); entry != entries.rend() && added < mostEvents; ++entry) {
        const Point at = onSheet(entry->place);
        if (!isGrave(entry->kind) || !isSeen(at)) continue;
        CallOut callOut;
        callOut.head = qt(entry->subject) + ' ' + qt(entry->what);
        const bool bore = entry->bolt >= 0 && entry->force > leastForce;
        callOut.detail = bore ? CallOutTexts::tr("%1 at t = %2").arg(qt(forceText(entry->force, picture_.numbers)),
                                                               qt(entry->when))
                              : CallOutTexts::tr("at t = %1").arg(qt(entry->when));
        callOut.edge = theme_.error;
        callOut.at = at;
        callOuts_.push_back(callOut);
        ++added;
    }
}

void SectionPainter::callOutMoved() {
    std::vector<const BlockShape*> farthest = moved_;
    std::sort(farthest.begin(), farthest.end(),
              [](const BlockShape* a, const BlockShape* b) { return a->displaced > b->displaced; });
    std::size_t added = 0;
    for (const BlockShape* block : farthest) {
        const std::vector<Point> outline = sheetPoints(block->outline);
        const Point foot = footWithin(outline);
        const auto& entries = picture_.events.entries;
        const bool hasFailed = std::any_of(entries.begin(), entries.end(), [&](const EventEntry& entry) {
            return entry.bolt < 0 && entry.block == block->block && isGrave(entry.kind);
        });
        if (hasFailed || !isSeen(foot) || added == mostMoved) continue;
        const QString way = qt(lengthText(block->displaced / picture_.factor, picture_.numbers));
        callOuts_.push_back({qt(block->name), CallOutTexts::tr("moved %1").arg(way), theme_.text2, foot, {0.0, 1.0}, true});
        ++added;
    }
}

}  // namespace keyblock
