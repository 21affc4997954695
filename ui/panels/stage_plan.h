// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which tunnel, block, bolt and pattern is there in which stage, as a table that a
// person reads at one glance and changes by clicks; and what else a stage does.
#pragma once

#include "solver/scene/scene.h"
#include "ui/edit/edit.h"

#include <QString>
#include <QStringList>

#include <string>
#include <vector>

namespace keyblock {

class Display;

/// What happens to a thing at the start of a stage, and whether it is there afterwards.
struct PlanCell {
    enum class Event { None, Excavated, Installed, Removed };
    Event event = Event::None;
    bool there = true;
};

struct PlanRow {
    std::string name;
    bool isBolt = false;  // comes and goes; else rock, which only goes
    QString icon;
    std::vector<PlanCell> cells;  // one for each stage
};

/// Tunnels, blocks with a name (as many as `mostPlanBlocks`), patterns and bolts.
std::vector<PlanRow> stagePlan(const Scene& scene);

inline constexpr std::size_t mostPlanBlocks = 40;

/// The cell the other way: rock is excavated in this stage (and in no other) or stays; a bolt that is not there yet is
/// installed, one that is there is removed, and what happens here already is taken back.
Edit toggled(const Scene& scene, const PlanRow& row, std::size_t stage);

/// `Excavate drift in excavate`.
QString toggledName(const Scene& scene, const PlanRow& row, std::size_t stage);

/// What the stage does, a few words each: `excavates drift`, `2 loads`.
QStringList stageDeeds(const Stage& stage, const Display& display);

/// When it ends: `at equilibrium`, `10 increments`, `0.5 s`.
QString stageEnd(const Stage& stage, const Display& display);

}  // namespace keyblock
