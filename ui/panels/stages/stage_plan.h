// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage plan, a table that shows in which stages each tunnel, block, bolt and
// pattern is present and that the user edits by clicks. Also texts for the other
// actions of a stage.
#pragma once

#include "solver/scene/scene.h"
#include "ui/edit/edit.h"

#include <QString>
#include <QStringList>

#include <string>
#include <vector>

namespace keyblock {

class Display;

/// What happens to an object at the start of a stage, and whether it is present afterwards.
struct PlanCell {
    enum class Event { None, Excavated, Installed, Removed };
    Event event = Event::None;
    bool there = true;
};

struct PlanRow {
    std::string name;
    bool isBolt = false;  // can be installed and removed; otherwise it is rock, which can only be excavated
    QString icon;
    std::vector<PlanCell> cells;  // one per stage
};

/// Rows for tunnels, named blocks (at most `mostPlanBlocks`), patterns and bolts.
std::vector<PlanRow> stagePlan(const Scene& scene);

inline constexpr std::size_t mostPlanBlocks = 40;

/// Toggles the cell of `row` for the stage with index `stage`. Rock is excavated in this stage and in no other; if this
/// stage already excavates it, the excavation is cancelled. If a bolt is installed or removed in this stage, this is
/// cancelled. Otherwise the bolt is removed if it is present and some stage installs it, and installed if not.
Edit toggled(const Scene& scene, const PlanRow& row, std::size_t stage);

/// Name of the undo step for `toggled`, e.g. `Excavate drift in Stage 1`.
QString toggledName(const Scene& scene, const PlanRow& row, std::size_t stage);

/// Short descriptions of what the stage does, e.g. `excavates drift` and `2 loads`.
QStringList stageDeeds(const Stage& stage, const Display& display);

/// Condition at which the stage ends, e.g. `at equilibrium`, `10 increments` or `0.5 s`.
QString stageEnd(const Stage& stage, const Display& display);

}  // namespace keyblock
