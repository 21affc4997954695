// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/stages/stage_plan.h"

#include "solver/scene/pointer.h"
#include "ui/edit/edits.h"
#include "ui/look/display.h"
#include "ui/panels/fields/value_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace keyblock {

namespace {

struct PlanTexts {
    Q_DECLARE_TR_FUNCTIONS(Stages)
};

bool names(const std::vector<std::string>& list, const std::string& name) {
    return std::ranges::find(list, name) != list.end();
}

PlanRow rockRow(const Scene& scene, const std::string& name, const char* icon, bool isTunnel) {
    PlanRow row{name, false, icon, {}};
    const bool everExcavated =
        std::ranges::any_of(scene.stages, [&](const Stage& s) { return names(s.excavate, name); });
    bool there = !isTunnel || everExcavated;  // a tunnel that no stage excavates is open from the start
    for (const Stage& stage : scene.stages) {
        const bool goes = names(stage.excavate, name);
        there = there && !goes;
        row.cells.push_back({goes ? PlanCell::Event::Excavated : PlanCell::Event::None, there});
    }
    return row;
}

PlanRow boltRow(const Scene& scene, const std::string& name, const char* icon) {
    PlanRow row{name, true, icon, {}};
    bool there = std::ranges::none_of(scene.stages, [&](const Stage& s) { return names(s.install, name); });
    for (const Stage& stage : scene.stages) {
        PlanCell cell;
        if (names(stage.install, name)) {
            cell.event = PlanCell::Event::Installed;
            there = true;
        } else if (names(stage.remove, name)) {
            cell.event = PlanCell::Event::Removed;
            there = false;
        }
        cell.there = there;
        row.cells.push_back(cell);
    }
    return row;
}

std::string listOf(std::size_t stage, const char* key) { return under(under("/stages", stage), key); }

Edit setNames(const Scene& scene, std::size_t stage, const char* key, const std::string& name, bool in) {
    auto list = std::get<std::vector<std::string>>(*valueAt(scene, listOf(stage, key)));
    if (names(list, name) == in) {
        Edit same;
        same.scene = scene;
        return same;
    }
    if (in)
        list.push_back(name);
    else
        std::erase(list, name);
    return setValueAt(scene, listOf(stage, key), list);
}

Edit excavateIn(const Scene& scene, const std::string& name, std::size_t stage) {
    const bool here = names(scene.stages[stage].excavate, name);
    Edit edit;
    edit.scene = scene;
    for (std::size_t i = 0; i < scene.stages.size() && edit.done(); ++i)
        edit = setNames(edit.scene, i, "excavate", name, i == stage && !here);
    return edit;
}

QString listed(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts) list << QString::fromStdString(text);
    return list.size() > 3 ? PlanTexts::tr("%1, %2 and %3 more").arg(list[0], list[1]).arg(list.size() - 2)
                           : list.join(", ");
}

QString counted(std::size_t count, const char* one, const char* many) {
    return QString("%1 %2").arg(count).arg(PlanTexts::tr(count == 1 ? one : many));
}

QString changeText(const StrengthChange& change, const Display& display) {
    const QString text = PlanTexts::tr("changes the strength of %1").arg(QString::fromStdString(change.jointMaterial));
    QStringList values;
    if (change.frictionAngle)
        values << QString::fromUtf8("φ %1°").arg(numberText(*change.frictionAngle, {}, display, 4));
    if (change.cohesion)
        values << QString("c %1 %2").arg(numberText(*change.cohesion, "Pa", display, 4), display.shown("Pa").symbol);
    return values.isEmpty() ? text : text + ": " + values.join(", ");
}

QString bodyAccelerationText(const Acceleration& acceleration, const Display& display) {
    if (!acceleration.value) return PlanTexts::tr("applies a body acceleration");
    return PlanTexts::tr("applies a body acceleration of %1 %2")
        .arg(numberText(acceleration.factor * *acceleration.value, "m/s²", display, 4), display.shown("m/s²").symbol);
}

}  // namespace

std::vector<PlanRow> stagePlan(const Scene& scene) {
    std::vector<PlanRow> rows;
    for (const SceneTunnel& tunnel : scene.tunnels) rows.push_back(rockRow(scene, tunnel.name, "tunnel", true));
    std::size_t blocks = 0;
    for (const Block& block : scene.blocks)
        if (!block.name.empty() && blocks++ < mostPlanBlocks)
            rows.push_back(rockRow(scene, block.name, "block", false));
    for (const ScenePattern& pattern : scene.boltPatterns) rows.push_back(boltRow(scene, pattern.name, "pattern"));
    for (const Bolt& bolt : scene.bolts) rows.push_back(boltRow(scene, bolt.name, "bolt"));
    return rows;
}

Edit toggled(const Scene& scene, const PlanRow& row, std::size_t stage) {
    if (!row.isBolt) return excavateIn(scene, row.name, stage);
    switch (row.cells[stage].event) {
        case PlanCell::Event::Installed: return setNames(scene, stage, "install", row.name, false);
        case PlanCell::Event::Removed: return setNames(scene, stage, "remove", row.name, false);
        default: break;
    }
    const bool everInstalled =
        std::ranges::any_of(scene.stages, [&](const Stage& s) { return names(s.install, row.name); });
    const bool there = row.cells[stage].there;
    return setNames(scene, stage, there && everInstalled ? "remove" : "install", row.name, true);
}

QString toggledName(const Scene& scene, const PlanRow& row, std::size_t stage) {
    const QString name = QString::fromStdString(row.name), in = QString::fromStdString(scene.stages[stage].name);
    if (row.cells[stage].event != PlanCell::Event::None) return PlanTexts::tr("Keep %1 unchanged in %2").arg(name, in);
    if (!row.isBolt) return PlanTexts::tr("Excavate %1 in %2").arg(name, in);
    const bool everInstalled =
        std::ranges::any_of(scene.stages, [&](const Stage& s) { return names(s.install, row.name); });
    const QString text = row.cells[stage].there && everInstalled ? PlanTexts::tr("Remove %1 in %2")
                                                                       : PlanTexts::tr("Install %1 in %2");
    return text.arg(name, in);
}

QStringList stageDeeds(const Stage& stage, const Display& display) {
    QStringList deeds;
    if (!stage.excavate.empty()) deeds << PlanTexts::tr("excavates %1").arg(listed(stage.excavate));
    if (stage.relaxation)
        deeds << PlanTexts::tr("releases %1 % of the wall forces")
                     .arg(numberText(100.0 * *stage.relaxation, {}, display, 4));
    if (!stage.install.empty()) deeds << PlanTexts::tr("installs %1").arg(listed(stage.install));
    if (!stage.remove.empty()) deeds << PlanTexts::tr("removes %1").arg(listed(stage.remove));
    for (const StrengthChange& change : stage.set) deeds << changeText(change, display);
    if (!stage.loads.empty())
        deeds << PlanTexts::tr("applies %1").arg(
            counted(stage.loads.size(), QT_TRANSLATE_NOOP("Stages", "load"), QT_TRANSLATE_NOOP("Stages", "loads")));
    if (!stage.motions.empty())
        deeds << PlanTexts::tr("prescribes %1").arg(counted(
            stage.motions.size(), QT_TRANSLATE_NOOP("Stages", "motion"), QT_TRANSLATE_NOOP("Stages", "motions")));
    for (const Dilation& dilation : stage.dilations)
        deeds << PlanTexts::tr("opens %1").arg(QString::fromStdString(dilation.joint));
    if (!stage.initialVelocities.empty())
        deeds << PlanTexts::tr("sets %1").arg(counted(stage.initialVelocities.size(),
                                                      QT_TRANSLATE_NOOP("Stages", "initial velocity"),
                                                      QT_TRANSLATE_NOOP("Stages", "initial velocities")));
    if (stage.baseAcceleration) deeds << PlanTexts::tr("applies a base acceleration");
    if (stage.bodyAcceleration) deeds << bodyAccelerationText(*stage.bodyAcceleration, display);
    if (stage.zeroDisplacements) deeds << PlanTexts::tr("resets displacements");
    return deeds;
}

QString stageEnd(const Stage& stage, const Display& display) {
    if (stage.kind == StageKind::Dynamic) return QString("%1 s").arg(numberText(stage.duration, "s", display, 4));
    if (stage.increments)
        return *stage.increments == 1 ? PlanTexts::tr("1 increment") : PlanTexts::tr("%1 increments").arg(*stage.increments);
    if (stage.until.unbalanced)
        return PlanTexts::tr("unbalanced force ratio < %1").arg(numberText(*stage.until.unbalanced, {}, display, 2));
    return PlanTexts::tr("at equilibrium");
}

}  // namespace keyblock
