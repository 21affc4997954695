// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/monitor_tool.h"

#include "geometry/segment.h"
#include "solver/scene/bolt_quantities.h"
#include "ui/edit/edits.h"
#include "ui/look/theme.h"
#include "ui/tools/sign_painter.h"
#include "ui/canvas/canvas_map.h"
#include "ui/tools/tool_painter.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double boltReach = 14.0;  // [px]

/// The axis along which the distance of the two points is larger.
Point axisBetween(const Point& a, const Point& b) {
    const Point way = (b - a).cwiseAbs();
    return way.x() >= way.y() ? Point(1.0, 0.0) : Point(0.0, 1.0);
}

}  // namespace

QString MonitorTool::prompt() const {
    if (what_ == AtPoint) return tr("pick the point to monitor");
    if (what_ == OnBolt) return tr("pick a point on a bolt");
    return first_ ? tr("pick a point on the other side of the joint") : tr("pick a point on one side of the joint");
}

std::vector<ToolField> MonitorTool::fields() {
    const auto tell = [this] {
        first_.reset();
        Q_EMIT changed();
    };
    std::vector<ToolField> fields{
        choiceField("what", tr("Target"), {tr("point"), tr("joint opening"), tr("bolt")}, what_, tell)};
    QStringList quantities;
    for (const BoltQuantityRow& row : boltQuantityRows) {
        const std::string_view title = plainTitle(row);
        quantities << QString::fromUtf8(title.data(), static_cast<int>(title.size()));
    }
    if (what_ == OnBolt) fields.push_back(choiceField("quantity", tr("Quantity"), quantities, quantity_, tell));
    return fields;
}

std::optional<Monitor> MonitorTool::boltAt(const Point& place) const {
    double nearest = bench().metres(boltReach);
    std::optional<Monitor> found;
    for (const SceneObject& object : bench().objects()) {
        if (object.kind != ObjectKind::Bolt && object.kind != ObjectKind::Pattern) continue;
        for (std::size_t i = 0; i < object.lines.size(); ++i) {
            const Point &head = object.lines[i].points[0], &end = object.lines[i].points[1];
            const double distance = distanceToSegment(head, end, place);
            if (distance >= nearest) continue;
            nearest = distance;
            found.emplace();
            std::string name = nameAt(scene(), object.pointer);
            if (object.kind == ObjectKind::Pattern) name += "." + std::to_string(i + 1);
            found->bolt = std::move(name);
            const double share = std::clamp(footParameter(end, head, place), 0.0, 1.0);
            found->atFraction = std::round(share * 100.0) / 100.0;
        }
    }
    return found;
}

void MonitorTool::press(const Pointed& at) {
    cursor_ = at.place;
    Monitor monitor;
    if (what_ == AtPoint) {
        monitor.point = at.place;
    } else if (what_ == Opening) {
        if (!first_) {
            first_ = at.place;
            return;
        }
        if ((at.place - *first_).norm() < 1e-12) return;
        monitor.between = {*first_, at.place};
        monitor.axis = axisBetween(*first_, at.place);
    } else {
        const auto bolt = boltAt(at.raw);
        if (!bolt) return bench().say(tr("There is no bolt at this point."), true);
        monitor = *bolt;
        monitor.quantity = static_cast<BoltQuantity>(quantity_);
    }
    place(monitor);
}

void MonitorTool::place(const Monitor& monitor) {
    first_.reset();
    bench().add(withMonitor(scene(), monitor));
}

bool MonitorTool::back() {
    if (!first_) return false;
    first_.reset();
    return true;
}

void MonitorTool::paint(QPainter& painter, const CanvasMap& map) const {
    SignPainter signs(painter, map, bench().theme());
    ToolPainter ink(painter, map, bench().theme());
    const QColor& colour = bench().theme().accent;
    if (first_) signs.monitor(*first_, {}, colour);
    if (cursor_ && (what_ != OnBolt || boltAt(*cursor_))) signs.monitor(*cursor_, {}, colour);
    if (first_ && cursor_) ink.ghost({*first_, *cursor_});
}

}  // namespace keyblock
