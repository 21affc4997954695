// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/load_tool.h"

#include "ui/edit/edits.h"
#include "ui/look/theme.h"
#include "ui/tools/choices.h"
#include "ui/tools/sign_painter.h"
#include "ui/tools/tool_painter.h"

#include <algorithm>

namespace keyblock {

QString LoadTool::prompt() const {
    if (scene().stages.empty()) return tr("add a stage first");
    if (what_ == AtPoint) return tr("pick the point of application");
    if (what_ == OnBlock) return tr("pick a point in the block");
    return first_ ? tr("pick the other end of the loaded line") : tr("pick one end of the loaded line");
}

std::vector<ToolField> LoadTool::fields() {
    const auto tell = [this] {
        first_.reset();
        Q_EMIT changed();
    };
    const QStringList stages = stageNames(scene());
    stage_ = std::clamp(stage_, 0, std::max(static_cast<int>(stages.size()) - 1, 0));
    std::vector<ToolField> fields{choiceField(
        "what", tr("Type"), {tr("force at a point"), tr("force on a block"), tr("pressure on a line")}, what_, tell)};
    if (!stages.isEmpty()) fields.push_back(choiceField("stage", tr("Stage"), stages, stage_, tell));
    const auto add = [&](const char* id, const QString& label, const char* unit, double& value) {
        fields.push_back(numberField(id, label, {}, unit, {}, value, [this] { Q_EMIT changed(); }));
    };
    if (what_ == Pressure) {
        add("pressure", tr("Pressure"), "Pa", pressure_);
    } else {
        add("force_x", tr("Fx"), "N", force_.x());
        add("force_y", tr("Fy"), "N", force_.y());
    }
    return fields;
}

void LoadTool::begin() {
    first_.reset();
    stage_ = std::max(static_cast<int>(scene().stages.size()) - 1, 0);
}

void LoadTool::press(const Pointed& at) {
    cursor_ = at.place;
    Load load;
    if (what_ == AtPoint) load.point = at.place, load.force = force_;
    if (what_ == OnBlock) load.blockAt = at.place, load.force = force_;
    if (what_ == Pressure) {
        if (!first_) {
            first_ = at.place;
            return;
        }
        if ((at.place - *first_).norm() < 1e-9) return;
        load.along = {*first_, at.place};
        load.pressure = pressure_;
    }
    place(std::move(load));
}

void LoadTool::place(Load load) {
    first_.reset();
    bench().add(withLoad(scene(), static_cast<std::size_t>(stage_), load));
}

bool LoadTool::back() {
    if (!first_) return false;
    first_.reset();
    return true;
}

void LoadTool::paint(QPainter& painter, const CanvasMap& map) const {
    if (!cursor_) return;
    SignPainter signs(painter, map, bench().theme());
    const QColor& colour = bench().theme().accent;
    if (what_ != Pressure) return signs.arrow(*cursor_, force_, 44.0, colour);
    if (first_) signs.pressure(*first_, *cursor_, pressure_ < 0.0, colour);
    ToolPainter ink(painter, map, bench().theme());
    if (first_) ink.corner(*first_);
}

}  // namespace keyblock
