// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/scene_overlay.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/locate.h"
#include "ui/look/theme.h"
#include "ui/tools/sign_painter.h"
#include "ui/tools/tool_painter.h"
#include "ui/tools/workbench.h"

#include <QPainter>
#include <QPainterPath>

#include <set>

namespace keyblock {
namespace {

/// True for objects that are part of the picture of a cut scene.
bool isInPicture(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::Domain:
        case ObjectKind::Joint:
        case ObjectKind::JointSet:
        case ObjectKind::Voronoi:
        case ObjectKind::Tunnel:
        case ObjectKind::Block:
        case ObjectKind::Bolt:
        case ObjectKind::Pattern: return true;
        default: return false;
    }
}

QPen penOf(ObjectKind kind, const Theme& theme) {
    switch (kind) {
        case ObjectKind::Domain:
        case ObjectKind::Tunnel:
        case ObjectKind::Block: return QPen(theme.wall, 1.6);
        case ObjectKind::Bolt:
        case ObjectKind::Pattern: return QPen(theme.markInk, 2.0);
        case ObjectKind::Region: return QPen(theme.text3, 1.2, Qt::DashLine);
        default: return QPen(theme.dark ? theme.text3 : theme.jointDrawing, 1.0);
    }
}

}  // namespace

const std::vector<SceneObject>& SceneOverlay::objects() const {
    const Document& document = bench_.document();
    if (!document.isPreviewing()) return bench_.objects();
    if (shown_ != document.scene()) {
        shown_ = document.scene();
        objects_ = objectsOf(*shown_);
        std::erase_if(objects_, [&](const SceneObject& object) { return bench_.isHidden(object.pointer); });
    }
    return objects_;
}

bool SceneOverlay::isShown() const {
    const Document& document = bench_.document();
    return document.checkIsCurrent() && document.checked().picture;
}

void SceneOverlay::paint(QPainter& painter, const CanvasMap& map) const {
    if (!bench_.isDrawing()) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintLines(painter, map);
    SignPainter signs(painter, map, bench_.theme());
    for (const SceneObject& object : objects()) signs.paint(*bench_.document().scene(), object);
    signs.paintNames();
    paintSelected(painter, map);
    painter.restore();
}

void SceneOverlay::paintLines(QPainter& painter, const CanvasMap& map) const {
    const bool inPicture = isShown();
    painter.setBrush(Qt::NoBrush);
    for (const SceneObject& object : objects()) {
        const bool signs = object.kind == ObjectKind::Support || object.kind == ObjectKind::Load;
        if (signs || (inPicture && isInPicture(object.kind))) continue;
        painter.setPen(penOf(object.kind, bench_.theme()));
        for (const ObjectLine& line : object.lines) {
            QPolygonF pixels;
            for (const Point& point : line.points) pixels << map.toPixel(point);
            line.closed ? painter.drawPolygon(pixels) : painter.drawPolyline(pixels);
        }
    }
}

/// The whole view except the openings.
QPainterPath SceneOverlay::rock(const CanvasMap& map) const {
    QPainterPath all, openings;
    all.addRect(QRectF(QPointF(), map.size()));
    for (const SceneObject& object : objects()) {
        if (object.kind != ObjectKind::Tunnel || object.area.empty()) continue;
        QPolygonF wall;
        for (const Point& point : object.area) wall << map.toPixel(point);
        QPainterPath opening;
        opening.addPolygon(wall);
        opening.closeSubpath();
        openings |= opening;
    }
    return all - openings;
}

/// Lines that end at openings are clipped. Clipping is slow, so these lines are painted together, after the others.
void SceneOverlay::paintSelected(QPainter& painter, const CanvasMap& map) const {
    std::set<std::string> holders;
    for (const QString& pointer : bench_.selection().pointers())
        holders.insert(objectPointer(*bench_.document().scene(), pointer.toStdString()));
    if (holders.empty()) return;
    ToolPainter ink(painter, map, bench_.theme());
    for (const bool clipped : {false, true})
        for (const SceneObject& object : objects()) {
            // The picture shows which of its bolts are selected.
            const bool isBolt = object.kind == ObjectKind::Bolt || object.kind == ObjectKind::Pattern;
            if (endsAtOpenings(object.kind) != clipped || !holders.contains(object.pointer) || (isBolt && isShown()))
                continue;
            if (clipped && !painter.hasClipping()) painter.setClipPath(rock(map));
            const double width = object.kind == ObjectKind::JointSet ? 1.3 : 2.0;  // thin: a joint set has many lines
            for (const ObjectLine& line : object.lines) ink.chosen(line.points, line.closed, width);
            for (const Point& mark : object.marks) ink.handle(mark, false);
        }
    painter.setClipping(false);
}

}  // namespace keyblock
