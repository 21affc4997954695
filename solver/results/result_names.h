// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words that tables, stores and answers use for kinds, outcomes and states,
// each in one place and readable both ways.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

std::string_view wordOf(EventKind kind);  // joint-slip … collapse
std::string_view wordOf(Outcome outcome);  // equilibrium, duration, limit, collapse, stopped, failed, displaced, undecided
std::string_view wordOf(Movement mode);  // slides, falls, topples, follows
std::string_view wordOf(NodeState state);  // bonded, slipping, gone, free
std::string_view wordOf(ContactState state);  // open, sliding, locked, bonded
std::string_view wordOf(ForceSource source);  // weight, contact, bolt, support, load, wall, glue, dashpot, inertia
std::string_view wordOf(StageKind kind);  // static, dynamic
std::string_view anchorWord(bool real);  // real, artificial

/// The kind of that word; nothing when there is none.
std::optional<EventKind> eventKindOf(std::string_view word);

/// The outcome of that word; nothing when there is none.
std::optional<Outcome> outcomeOf(std::string_view word);

/// The name at a row of the solved blocks; empty for an index that is not of a block.
std::string blockName(const std::vector<std::string>& names, int block);

/// The bolt's name; empty for an index that is not of a bolt.
std::string boltName(const Scene& scene, int bolt);

/// The stage's name; empty for an index that is not of a stage.
std::string stageName(const Scene& scene, int stage);

/// The name with the word before it, said once: "stage release", "stage 4"; empty for an index that is not of a stage.
std::string stageTitle(const Scene& scene, int stage);

}  // namespace keyblock
