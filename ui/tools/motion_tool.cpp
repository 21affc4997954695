// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/motion_tool.h"

#include "ui/edit/edits.h"
#include "ui/look/theme.h"
#include "ui/tools/choices.h"
#include "ui/tools/sign_painter.h"

#include <algorithm>

namespace keyblock {

QString MotionTool::prompt() const {
    return scene().stages.empty() ? tr("add a stage first") : tr("pick the block to move");
}

std::vector<ToolField> MotionTool::fields() {
    const auto tell = [this] { Q_EMIT changed(); };
    const QStringList stages = stageNames(scene());
    stage_ = std::clamp(stage_, 0, std::max(static_cast<int>(stages.size()) - 1, 0));
    std::vector<ToolField> fields;
    if (!stages.isEmpty()) fields.push_back(choiceField("stage", tr("Stage"), stages, stage_, tell));
    fields.push_back(choiceField("axis", tr("Along"), {"x", "y"}, axis_, tell));
    fields.push_back(numberField("displacement", tr("Displacement"), tr("Displacement at the end of the stage."), "m",
                                 {}, displacement_, tell));
    return fields;
}

void MotionTool::begin() { stage_ = std::max(static_cast<int>(scene().stages.size()) - 1, 0); }

void MotionTool::press(const Pointed& at) {
    cursor_ = at.place;
    Motion motion;
    motion.blockAt = at.place;
    motion.axis = axis_ == 0 ? Point(1.0, 0.0) : Point(0.0, 1.0);
    const std::size_t stage = stage_;
    const bool dynamic = stage < scene().stages.size() && scene().stages[stage].kind == StageKind::Dynamic;
    const double end = dynamic ? std::max(scene().stages[stage].duration, 1e-3) : 1.0;
    motion.table = {{0.0, 0.0}, {end, displacement_}};
    bench().add(withMotion(scene(), stage, motion));
}

void MotionTool::paint(QPainter& painter, const CanvasMap& map) const {
    if (!cursor_) return;
    const double sign = displacement_ < 0.0 ? -1.0 : 1.0;
    const Point axis = sign * (axis_ == 0 ? Point(1.0, 0.0) : Point(0.0, 1.0));
    SignPainter(painter, map, bench().theme()).motion(*cursor_, axis, bench().theme().accent);
}

}  // namespace keyblock
