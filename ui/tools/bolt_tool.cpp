// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/bolt_tool.h"

#include "ui/edit/anchor_edit.h"
#include "ui/edit/edits.h"
#include "ui/tools/choices.h"
#include "ui/tools/tool_painter.h"

#include <cassert>

namespace keyblock {
namespace {

constexpr double wallSnapReach = 24.0;  // [px]

}  // namespace

QString BoltTool::prompt() const {
    if (!head_) return tr("pick the head, on a wall or in the rock");
    return headWall_ ? tr("pick the far end; Enter places the bolt perpendicular to the wall")
                     : tr("pick the far end");
}

QString BoltTool::detail() const {
    if (head_ && cursor_) return lengthText((*cursor_ - *head_).norm());
    if (wall_) return tr("%1 perpendicular to the %2").arg(lengthText(length_), QString::fromStdString(wall_->name));
    return {};
}

QString BoltTool::commitText() const { return head_ && headWall_ ? tr("Place bolt") : QString(); }

std::vector<ToolField> BoltTool::fields() {
    const QStringList types = boltTypeNames(scene());
    keepAmong(bolt_.type, types);
    const auto tell = [this] { Q_EMIT changed(); };
    const auto row = [&](const char* key, const QString& label, const QStringList& choices = {}) {
        return rowField("bolts", key, &bolt_, label, tell, choices);
    };
    const ToolField length =
        numberField("length", tr("Length"), tr("Length of a bolt perpendicular to a wall."), "m", {0.0, 1e4, true},
                    length_, tell);
    std::vector<ToolField> fields{row("type", tr("Type"), types), length, row("plate", tr("Plate")),
                                  row("spacing_out_of_plane", tr("Out-of-plane spacing")),
                                  row("pretension", tr("Pretension"))};
    fields[3].none = lengthText(scene().analysis.thickness).section(' ', 0, 0);
    return fields;
}

void BoltTool::begin() {
    head_.reset();
    if (bolt_.type.empty()) bolt_.type = "d-bolt-20";
}

void BoltTool::move(const Pointed& at) {
    cursor_ = at.place;
    wall_ = head_ || at.typed ? std::nullopt : wallAt(scene(), at.place, bench().metres(wallSnapReach));
}

void BoltTool::press(const Pointed& at) {
    cursor_ = at.place;
    if (head_) {
        if ((at.place - *head_).norm() > 1e-9) place(*head_, at.place);
        return;
    }
    const auto wall = wallAt(scene(), at.place, at.typed ? 1e-3 : bench().metres(wallSnapReach));
    if (wall && !at.modifiers.testFlag(Qt::ControlModifier)) {
        place(wall->place, wall->place + length_ * wall->inward);
        return;
    }
    head_ = wall ? wall->place : at.place;  // with Ctrl, the far end is also picked
    headWall_ = wall;
    wall_.reset();
}

Point BoltTool::squareEnd() const {
    assert(headWall_);
    return headWall_->place + length_ * headWall_->inward;
}

bool BoltTool::enter() { return head_ && headWall_ && place(*head_, squareEnd()); }

bool BoltTool::place(const Point& head, const Point& farEnd) {
    Bolt bolt = bolt_;
    bolt.head = head, bolt.farEnd = farEnd;
    bolt.name.clear();
    if (!bench().add(withBolt(scene(), bolt))) return false;
    head_.reset();
    return true;
}

bool BoltTool::back() {
    if (!head_) return false;
    head_.reset();
    return true;
}

bool BoltTool::accepts(const Snap& snap) const {
    if (head_ || !wallAt(scene(), snap.place, bench().metres(wallSnapReach))) return true;
    return wallAt(scene(), snap.place, bench().metres(2.0)).has_value();  // points that are not on the wall are ignored
}

void BoltTool::paint(QPainter& painter, const CanvasMap& map) const {
    ToolPainter ink(painter, map, bench().theme());
    const bool plate = bolt_.plate != PlateKind::None;
    const auto nodes = [&](double length) { return nodesAhead(scene(), bolt_.type, length, bolt_.divisions); };
    if (wall_) {
        const Point end = wall_->place + length_ * wall_->inward;
        ink.bolt(wall_->place, end, plate, nodes(length_));
        ink.dimension(wall_->place, end, lengthText(length_), 24.0);
    }
    if (head_ && cursor_) {
        ink.bolt(*head_, *cursor_, plate, nodes((*cursor_ - *head_).norm()));
        ink.dimension(*head_, *cursor_, lengthText((*cursor_ - *head_).norm()), 24.0);
    }
}

}  // namespace keyblock
