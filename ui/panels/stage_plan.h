// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In which stages each tunnel, block, bolt and pattern is present, as a table that
// the user can change by clicks, and the other actions of a stage.
#pragma once

#include "solver/scene/scene.h"
#include "ui/edit/edit.h"

#include <QString>
#include <QStringList>

#include <string>
#include <vector>

namespace keyblock {

class Display;

/// Change of an object at the start of a stage, and whether it is present afterwards.
struct PlanCell {
    enum class Event { None, Excavated, Installed, Removed };
    Event event = Event::None;
    bool there = true;
};

struct PlanRow {
    std::string name;
    bool isBolt = false;  // may be installed and removed; else rock, which can only be excavated
    QString icon;
    std::vector<PlanCell> cells;  // one for each stage
};

/// Tunnels, blocks with a name (as many as `mostPlanBlocks`), patterns and bolts.
std::vector<PlanRow> stagePlan(const Scene& scene);

inline constexpr std::size_t mostPlanBlocks = 40;

/// Toggles a cell: rock is excavated in this stage (and in no other) or stays; an absent bolt is installed,
/// a present one is removed, and a change that is already in this stage is undone.
Edit toggled(const Scene& scene, const PlanRow& row, std::size_t stage);

/// `Excavate drift in excavate`.
QString toggledName(const Scene& scene, const PlanRow& row, std::size_t stage);

/// The actions of the stage in a few words each: `excavates drift`, `2 loads`.
QStringList stageDeeds(const Stage& stage, const Display& display);

/// When it ends: `at equilibrium`, `10 increments`, `0.5 s`.
QString stageEnd(const Stage& stage, const Display& display);

}  // namespace keyblock
