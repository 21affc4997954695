// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pattern_tool.h"

#include "geometry/shape/bolt_pattern.h"
#include "solver/scene/shapes.h"
#include "ui/canvas/canvas.h"
#include "ui/edit/anchor_edit.h"
#include "ui/edit/edits.h"
#include "ui/tools/choices.h"
#include "ui/tools/tool_painter.h"

#include <QPainter>

#include <algorithm>
#include <cassert>
#include <limits>
#include <variant>

namespace keyblock {
namespace {

constexpr double roomForNumbers = 80.0;  // [px] shortest bolt with space for the numbers
constexpr double firstReach = 60.0;  // [px] largest distance of the first pick from the wall
constexpr double samePlace = 1e-9;  // [m]
constexpr double mostBolts = 1000.0;

}  // namespace

const SceneTunnel& PatternTool::tunnel() const {
    assert(from_);
    return scene().tunnels[from_->tunnel];
}

QString PatternTool::prompt() const {
    if (scene().tunnels.empty()) return tr("draw a tunnel first");
    if (!from_) return tr("pick the first point on the wall");
    return to_ ? tr("Enter places the bolts; click to pick a different last point")
               : tr("pick the last point on the wall");
}

QString PatternTool::detail() const {
    if (!from_ || !runEnd()) return {};
    if (const auto problem = boltPatternProblem(patternOf(pattern_))) return QString::fromStdString(problem->message);
    const QString bolts = bolts_.size() == 1 ? tr("1 bolt") : tr("%1 bolts").arg(bolts_.size());
    const QString apart = bolts_.size() > 1 ? ' ' + tr("%1 apart").arg(lengthText(pattern_.spacing)) : QString();
    return bolts + apart + ' ' +
           tr("over %1 along the wall of %2").arg(lengthText(run_), QString::fromStdString(tunnel().name));
}

QString PatternTool::commitText() const {
    if (bolts_.empty()) return {};
    return bolts_.size() == 1 ? tr("Place 1 bolt") : tr("Place %1 bolts").arg(bolts_.size());
}

std::vector<ToolField> PatternTool::fields() {
    const QStringList types = boltTypeNames(scene());
    keepAmong(pattern_.type, types);
    const auto tell = [this] { changedOptions(); };
    const auto row = [&](const char* key, const QString& label, const QStringList& choices = {}) {
        return rowField("bolt_patterns", key, &pattern_, label, tell, choices);
    };
    // Keeps the values set by the user, from which the pattern is fitted again for a new end point.
    const auto given = [&](const char* key, const QString& label, double& value) {
        ToolField field = rowField("bolt_patterns", key, &pattern_, label, [] {});
        field.get = [&value] { return FieldValue(value); };
        field.set = [this, &value, check = field.set](const FieldValue& typed) {
            const QString problem = check(typed);
            if (const auto* number = std::get_if<double>(&typed); number && problem.isEmpty()) {
                value = *number;
                changedOptions();  // last, because the bar replaces its fields
            }
            return problem;
        };
        return field;
    };
    std::vector<ToolField> fields{row("type", tr("Type"), types)};
    if (fit() == PatternFit::EndToEnd) {
        fields.push_back(numberField("count", tr("Bolts"), tr("Number of bolts, including one at each end."),
                                     {}, {.least = 1.0, .most = mostBolts}, count_, tell));
        fields.back().isInteger = true;
    } else {
        fields.push_back(given("spacing", tr("Spacing"), given_.spacing));
    }
    fields.push_back(row("length", tr("Length")));
    fields.push_back(choiceField("fit", tr("Layout"), {tr("from the start"), tr("centred"), tr("end to end")}, fit_, tell));
    fields.back().help = tr("From the start: bolts at the given spacing, laid out from the first point. Centred: "
                            "bolts at the given spacing, with equal distances left at both ends. End to end: a given "
                            "number of bolts, evenly spaced.");
    fields.push_back(row("angle_from_wall", tr("Angle from wall")));
    fields.push_back(row("plate", tr("Plate")));
    if (fit() == PatternFit::FromStart) fields.push_back(given("offset", tr("Offset"), given_.offset));
    fields.push_back(row("spacing_out_of_plane", tr("Out-of-plane spacing")));
    fields.back().none = lengthText(scene().analysis.thickness).section(' ', 0, 0);
    fields.push_back(rowField("bolt_patterns", "way", &pattern_, tr("Direction"), [this] {
        wayChosen_ = true;
        changedOptions();
    }));
    return fields;
}

void PatternTool::begin() {
    from_.reset(), to_.reset(), hover_.reset();
    wayChosen_ = false;
    bolts_.clear();
    if (pattern_.spacing > 0.0) return;  // keeps the values of the previous pattern
    const Edit fresh = appendAt(scene(), "/bolt_patterns");
    pattern_ = fresh.scene.boltPatterns.back();
    given_ = {pattern_.spacing, pattern_.offset};
}

void PatternTool::refresh() {
    if (from_ && (from_->tunnel >= static_cast<int>(scene().tunnels.size()) ||
                  !wallOfTunnel(scene(), from_->tunnel, from_->place)))
        begin();
    else
        layOut();
}

void PatternTool::changedOptions() {
    layOut();
    Q_EMIT changed();
}

void PatternTool::move(const Pointed& at) {
    const std::size_t before = bolts_.size();
    if (from_) {
        hover_ = to_ ? std::nullopt : wallOfTunnel(scene(), from_->tunnel, at.place);
    } else {
        hover_.reset();
        double nearest = at.typed ? std::numeric_limits<double>::infinity() : bench().metres(firstReach);
        for (int i = 0; i < static_cast<int>(scene().tunnels.size()); ++i) {
            const auto wall = wallOfTunnel(scene(), i, at.place);
            if (!wall || (wall->place - at.place).norm() >= nearest) continue;
            nearest = (wall->place - at.place).norm();
            hover_ = wall;
        }
    }
    layOut();
    if (bolts_.size() != before) Q_EMIT changed();  // the button shows the number of bolts
}

void PatternTool::press(const Pointed& at) {
    move(at);
    if (!from_) {
        from_ = hover_;
        hover_.reset();
        wayChosen_ = false;
    } else {
        to_ = wallOfTunnel(scene(), from_->tunnel, at.place);
    }
    changedOptions();
}

void PatternTool::layOut() {
    bolts_.clear();
    run_ = 0.0;
    const auto to = runEnd();
    if (!from_ || !to) return;
    pattern_.tunnel = tunnel().name;
    pattern_.from = from_->place, pattern_.to = to->place;
    const double ccw = runAlong(tunnel(), from_->along, to->along, Way::CounterClockwise);
    const double cw = runAlong(tunnel(), from_->along, to->along, Way::Clockwise);
    if (!wayChosen_) pattern_.way = ccw <= cw ? Way::CounterClockwise : Way::Clockwise;
    run_ = pattern_.way == Way::CounterClockwise ? ccw : cw;
    const bool isClosed = (from_->place - to->place).norm() < samePlace;
    const PatternPlaces places = fitted(fit(), given_, static_cast<int>(count_), run_, isClosed);
    pattern_.spacing = places.spacing, pattern_.offset = places.offset;
    bolts_ = boltsOfPattern(scene(), pattern_);
}

bool PatternTool::enter() {
    if (bolts_.empty()) return false;
    ScenePattern pattern = pattern_;
    pattern.name.clear();
    if (!bench().add(withPattern(scene(), pattern))) return false;
    begin();
    return true;
}

bool PatternTool::back() {
    if (to_) {
        to_.reset();
    } else if (from_) {
        from_.reset(), hover_.reset();
    } else {
        return false;
    }
    layOut();
    return true;
}

std::optional<Point> PatternTool::previous() const { return from_ ? std::optional(from_->place) : std::nullopt; }

bool PatternTool::accepts(const Snap& snap) const {
    const auto wall = wallAt(scene(), snap.place, bench().metres(2.0));
    return wall && wall->tunnel >= 0;
}

void PatternTool::paint(QPainter& painter, const CanvasMap& map) const {
    ToolPainter ink(painter, map, bench().theme());
    const auto to = runEnd();
    if (from_ && to) ink.wall(wallBetween(tunnel(), from_->along, to->along, pattern_.way));
    const bool plates = pattern_.plate != PlateKind::None;
    const std::vector<NodeAhead> nodes = nodesAhead(scene(), pattern_.type, pattern_.length, pattern_.divisions);
    for (const ObjectLine& bolt : bolts_) ink.bolt(bolt.points[0], bolt.points[1], plates, nodes);
    const double scale = map.pixelsPerMetre();
    const bool roomy = scale * pattern_.length > roomForNumbers;  // otherwise the numbers would overlap
    if (bolts_.size() > 1 && roomy && scale * pattern_.spacing > 0.5 * roomForNumbers) {
        const bool left = pattern_.way == Way::CounterClockwise;
        const std::size_t middle = (bolts_.size() - 1) / 2;
        ink.dimension(bolts_[middle].points[0], bolts_[middle + 1].points[0], lengthText(pattern_.spacing),
                      left ? 30.0 : -30.0);
    }
    if (!bolts_.empty() && roomy)
        ink.dimension(bolts_.back().points[0], bolts_.back().points[1], lengthText(pattern_.length), 26.0);
    if (from_) {
        ink.handle(from_->place, false);
        const Point opening = from_->place - from_->inward;
        const QPointF in = map.toPixel(opening) - map.toPixel(from_->place);
        const double size = std::hypot(in.x(), in.y());
        if (size > 0.0 && roomy) ink.label(map.toPixel(from_->place) + in / size * 62.0, tr("from %1").arg(placeText(from_->place)));
    }
    if (to_) ink.handle(to_->place, false);
    if (hover_ && !from_) ink.handle(hover_->place, true);
}

}  // namespace keyblock
