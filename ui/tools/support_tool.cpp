// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/support_tool.h"

#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "solver/scene/shapes.h"
#include "solver/scene/enum_names.h"
#include "ui/edit/edits.h"
#include "ui/look/theme.h"
#include "ui/tools/sign_painter.h"

#include <limits>

namespace keyblock {

QString SupportTool::prompt() const {
    switch (what_) {
        case Side:
            return scene().domain ? tr("pick a side of the outline")
                                  : tr("draw the outline of the rock first, or support a point instead");
        case Place: return tr("pick the point to support");
        default: return tr("pick the block to support");
    }
}

QString SupportTool::detail() const {
    const auto side = cursor_ && what_ == Side ? sideAt(*cursor_) : std::nullopt;
    if (!side) return {};
    const std::string_view word = boundarySideWords[static_cast<std::size_t>(*side)];
    return QString::fromUtf8(word.data(), static_cast<int>(word.size()));
}

std::vector<ToolField> SupportTool::fields() {
    const auto tell = [this] { Q_EMIT changed(); };
    std::vector<ToolField> fields{
        choiceField("what", tr("Support"), {tr("side"), tr("point"), tr("block")}, what_, tell)};
    if (what_ != Whole) fields.push_back(choiceField("fix", tr("Fixed"), {"x, y", "x", "y"}, fix_, tell));
    return fields;
}

std::optional<BoundarySide> SupportTool::sideAt(const Point& place) const {
    if (!scene().domain || scene().domain->boundary.size() < 3) return std::nullopt;
    const std::vector<Point> corners = counterClockwise(scene().domain->boundary);
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<BoundarySide> side;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double distance = distanceToSegment(a, b, place);
        if (distance < nearest) nearest = distance, side = sideOf(a, b);
    }
    return side;
}

Support SupportTool::supportAt(const Point& place) const {
    Support support;
    support.fix = what_ == Whole ? Fix::All : fix_ == 0 ? Fix::XY : fix_ == 1 ? Fix::X : Fix::Y;
    if (what_ == Side) support.boundary = sideAt(place);
    if (what_ == Place) support.point = place;
    if (what_ == Whole) support.blockAt = place;
    return support;
}

void SupportTool::press(const Pointed& at) {
    cursor_ = at.place;
    const Support support = supportAt(at.place);
    if (what_ == Side && !support.boundary) return bench().say(tr("Draw the outline of the rock first."), true);
    const Edit edit = withSupport(scene(), support);
    bench().add(edit, tr("Add %1").arg(QString::fromStdString(titleAt(edit.scene, edit.made))));
}

void SupportTool::paint(QPainter& painter, const CanvasMap& map) const {
    if (!cursor_) return;
    SignPainter signs(painter, map, bench().theme());
    const Support support = supportAt(*cursor_);
    const QColor& colour = bench().theme().accent;
    if (what_ != Side) return signs.held(*cursor_, support.fix, colour);
    if (!support.boundary) return;
    const std::vector<Point> corners = counterClockwise(scene().domain->boundary);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if (sideOf(a, b) == support.boundary) signs.side(a, b, support.fix, colour);
    }
}

}  // namespace keyblock
