// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/joint_set_tool.h"

#include "geometry/angle.h"
#include "geometry/shape/joint_set.h"
#include "solver/scene/shapes.h"
#include "ui/canvas/canvas.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/look/theme.h"
#include "ui/tools/choices.h"
#include "ui/tools/tool_painter.h"

#include <QPainter>

#include <cmath>

namespace keyblock {
namespace {

constexpr std::size_t mostDashed = 150;  // traces; more would be slow to paint dashed, and hard to distinguish

/// The dip of a line, −90° < dip ≤ 90°, because opposite directions are equivalent.
double dipOf(const Point& way) {
    double dip = std::atan2(way.y(), way.x()) / radiansPerDegree;
    if (dip > 90.0) dip -= 180.0;
    if (dip <= -90.0) dip += 180.0;
    return std::round(dip * 10.0) / 10.0;
}

}  // namespace

QString JointSetTool::prompt() const {
    if (!scene().domain) return tr("draw the outline of the rock first");
    return picked_ ? tr("pick the direction of the traces") : tr("pick a point on a trace; Enter places the traces");
}

QString JointSetTool::detail() const {
    if (!scene().domain) return {};
    if (const auto problem = jointSetProblem(jointSetOf(set_))) return QString::fromStdString(problem->message);
    if (traces_.empty()) return tr("too many traces to draw, or none in the region");
    return traces_.size() == 1 ? tr("1 trace, seed %1").arg(set_.seed)
                               : tr("%1 traces, seed %2").arg(traces_.size()).arg(set_.seed);
}

QString JointSetTool::commitText() const {
    if (traces_.empty()) return {};
    return traces_.size() == 1 ? tr("Place 1 trace") : tr("Place %1 traces").arg(traces_.size());
}

std::vector<ToolField> JointSetTool::fields() {
    const QStringList materials = jointMaterialNames(scene()), regions = regionNames(scene());
    keepAmong(set_.jointMaterial, materials);
    keepAmong(set_.region, regions);
    const auto redraw = [this] { tell(); };
    const auto row = [&](const char* key, const QString& label, const QStringList& choices = {}) {
        return rowField("joint_sets", key, &set_, label, redraw, choices);
    };
    std::vector<ToolField> fields{row("dip", tr("Dip")), row("spacing", tr("Spacing")),
                                  row("spacing_deviation", tr("Spacing deviation")),
                                  row("dip_deviation", tr("Dip deviation")),
                                  row("trace_length", tr("Length"))};
    fields.back().none = tr("through");
    if (set_.traceLength) fields.push_back(row("bridge", tr("Bridge")));
    fields.push_back(row("seed", tr("Seed")));
    fields.push_back(row("joint_material", tr("Material"), materials));
    if (!regions.isEmpty()) fields.push_back(row("region", tr("Region"), regions));
    return fields;
}

void JointSetTool::begin() {
    picked_.reset();
    next();
}

void JointSetTool::next() {
    const Edit fresh = appendAt(scene(), "/joint_sets");
    const SceneJointSet before = set_;
    set_ = fresh.scene.jointSets.back();
    if (before.spacing > 0.0) {  // like the previous set, but with another direction
        set_.spacing = before.spacing, set_.spacingDeviation = before.spacingDeviation;
        set_.dipDeviation = before.dipDeviation, set_.jointMaterial = before.jointMaterial;
    }
    draw();
}

void JointSetTool::draw() { traces_ = tracesOfSet(scene(), set_); }

void JointSetTool::tell() {
    if (!set_.traceLength) set_.bridge = 0.0;
    draw();
    Q_EMIT changed();
}

void JointSetTool::press(const Pointed& at) {
    cursor_ = at.place;
    if (!scene().domain) return;
    if (!picked_) {
        picked_ = at.place;
        set_.origin = at.place;
    } else if ((at.place - *picked_).norm() > 1e-9) {
        set_.dip = dipOf(at.place - *picked_);
        picked_.reset();
    }
    tell();
}

bool JointSetTool::enter() {
    if (traces_.empty()) return false;
    SceneJointSet set = set_;
    set.name.clear();
    if (!bench().add(withJointSet(scene(), set))) return false;
    bench().selection().clear();  // its traces would hide the preview of the next set
    picked_.reset();
    next();
    return true;
}

bool JointSetTool::back() {
    if (!picked_) return false;
    picked_.reset();
    return true;
}

void JointSetTool::paint(QPainter& painter, const CanvasMap& map) const {
    ToolPainter ink(painter, map, bench().theme());
    if (traces_.size() <= mostDashed) {
        for (const ObjectLine& trace : traces_) ink.ghost(trace.points, false, 1.2);
    } else {
        QVector<QLineF> lines;
        for (const ObjectLine& trace : traces_)
            lines << QLineF(map.toPixel(trace.points.front()), map.toPixel(trace.points.back()));
        QColor colour = bench().theme().accent;
        colour.setAlphaF(0.6);
        painter.setPen(QPen(colour, 1.0));
        painter.drawLines(lines);
    }
    if (!scene().domain) return;
    if (!picked_) return ink.dot(set_.origin);
    ink.dot(*picked_);
    if (!cursor_ || *cursor_ == *picked_) return;
    ink.chosen({*picked_, *cursor_}, false, 1.6);
    ink.label(map.toPixel(*cursor_) + QPointF(0.0, -22.0), angleText(dipOf(*cursor_ - *picked_)));
}

}  // namespace keyblock
