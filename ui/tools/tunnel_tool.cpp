// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tunnel_tool.h"

#include "geometry/polygon.h"
#include "solver/scene/shapes.h"
#include "ui/edit/edits.h"
#include "ui/tools/tool_painter.h"

namespace keyblock {
namespace {

/// Clears the values that are used only by other profiles.
SceneTunnel withoutOthers(SceneTunnel tunnel) {
    const SceneTunnel none;
    if (!rowApplies("tunnels", "diameter", &tunnel)) tunnel.diameter = none.diameter;
    if (!rowApplies("tunnels", "width", &tunnel)) tunnel.width = none.width;
    if (!rowApplies("tunnels", "height", &tunnel)) tunnel.height = none.height;
    if (!rowApplies("tunnels", "wall_height", &tunnel)) tunnel.wallHeight = none.wallHeight;
    if (!rowApplies("tunnels", "rise", &tunnel)) tunnel.rise = none.rise;
    if (!rowApplies("tunnels", "center", &tunnel)) tunnel.center = none.center;
    if (!rowApplies("tunnels", "points", &tunnel)) tunnel.points.clear();
    return tunnel;
}

}  // namespace

QString TunnelTool::prompt() const {
    if (!isDrawn()) return tr("pick the centre");
    return corners_.size() < 3 ? tr("pick the next corner") : tr("pick the next corner; Enter closes the profile");
}

QString TunnelTool::detail() const {
    if (isDrawn()) return corners_.size() == 1 ? tr("1 corner") : tr("%1 corners").arg(corners_.size());
    if (const auto problem = profileProblem(shapeOf(placed({0.0, 0.0})))) return QString::fromStdString(problem->message);
    return cursor_ ? placeText(*cursor_) : QString();
}

QString TunnelTool::commitText() const { return isDrawn() && corners_.size() >= 3 ? tr("Place tunnel") : QString(); }

std::vector<ToolField> TunnelTool::fields() {
    const auto tell = [this] {
        corners_.clear();
        Q_EMIT changed();
    };
    std::vector<ToolField> fields{rowField("tunnels", "profile", &tunnel_, tr("Profile"), tell)};
    const auto add = [&](const char* key, const QString& label) {
        if (rowApplies("tunnels", key, &tunnel_)) fields.push_back(rowField("tunnels", key, &tunnel_, label, tell));
    };
    add("diameter", tr("Diameter"));
    add("width", tr("Width"));
    add("height", tr("Height"));
    add("wall_height", tr("Wall height"));
    add("rise", tr("Rise"));
    return fields;
}

void TunnelTool::begin() {
    corners_.clear();
    if (tunnel_.width > 0.0) return;  // keeps the values of the previous tunnel
    tunnel_.profile = ProfileKind::DShape;
    tunnel_.width = tunnel_.height = tunnel_.diameter = 5.0;
    tunnel_.wallHeight = 3.0, tunnel_.rise = 1.5;
}

SceneTunnel TunnelTool::placed(const Point& center) const {
    SceneTunnel tunnel = tunnel_;
    tunnel.center = center;
    tunnel.points = corners_;
    return withoutOthers(std::move(tunnel));
}

bool TunnelTool::place(const SceneTunnel& tunnel) {
    if (!bench().add(withTunnel(scene(), tunnel))) return false;
    corners_.clear();
    Q_EMIT finished("select");  // at its handles
    return true;
}

void TunnelTool::press(const Pointed& at) {
    cursor_ = at.place;
    if (!isDrawn()) {
        place(placed(at.place));
    } else if (corners_.size() >= 3 && (at.place - corners_.front()).norm() <= bench().metres(9.0) && !at.typed) {
        enter();
    } else if (corners_.empty() || (at.place - corners_.back()).norm() > 1e-9) {
        corners_.push_back(at.place);
    }
}

void TunnelTool::doubleClick(const Pointed& at) {
    if (!isDrawn() || corners_.size() < 3) return press(at);
    enter();
}

bool TunnelTool::enter() { return isDrawn() && corners_.size() >= 3 && place(placed({0.0, 0.0})); }

bool TunnelTool::back() {
    if (corners_.empty()) return false;
    corners_.clear();
    return true;
}

bool TunnelTool::undoPoint() {
    if (corners_.empty()) return false;
    corners_.pop_back();
    return true;
}

std::optional<Point> TunnelTool::previous() const {
    return corners_.empty() ? std::nullopt : std::optional(corners_.back());
}

void TunnelTool::paint(QPainter& painter, const CanvasMap& map) const {
    ToolPainter ink(painter, map, bench().theme());
    std::vector<Point> line = corners_;
    if (!isDrawn()) {
        if (!cursor_ || profileProblem(shapeOf(placed(*cursor_)))) return;
        line = outline(tunnelProfile(shapeOf(placed(*cursor_))));
        ink.dot(*cursor_);
    } else if (cursor_) {
        line.push_back(*cursor_);
    }
    if (line.size() < 2) return;
    ink.ghostFill(line);
    ink.ghost(line, line.size() > 2, 2.0);
    for (const Point& corner : corners_) ink.corner(corner);
    if (isDrawn()) return;
    const Box box = boxOf(line);
    ink.dimension(box.min, {box.max.x(), box.min.y()}, lengthText(box.max.x() - box.min.x()), -18.0);
    ink.dimension({box.max.x(), box.min.y()}, box.max, lengthText(box.max.y() - box.min.y()), -18.0);
}

}  // namespace keyblock
