// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words used in tables, stores and JSON output for event kinds, outcomes and
// states, and the conversion back from some of these words.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

std::string_view wordOf(EventKind kind);  // joint-slip … collapse
std::string_view wordOf(Outcome outcome);  // equilibrium, duration, limit, collapse, stopped, failed, …
std::string_view wordOf(Movement mode);  // slides, falls, topples, follows
std::string_view wordOf(NodeState state);  // bonded, slipping, gone, free
std::string_view wordOf(ContactState state);  // open, sliding, locked, bonded
std::string_view wordOf(ForceSource source);  // weight, contact, bolt, support, load, wall, glue, dashpot, inertia
std::string_view wordOf(StageKind kind);  // static, dynamic
std::string_view anchorWord(bool real);  // real, artificial

/// The event kind for this word; none if there is no such kind.
std::optional<EventKind> eventKindOf(std::string_view word);

/// The outcome for this word; none if there is no such outcome.
std::optional<Outcome> outcomeOf(std::string_view word);

/// Name of the block with index `block` in the frames; empty if the index does not refer to a block.
/// \param names the block names of the run, as returned by `blockNames`.
std::string blockName(const std::vector<std::string>& names, int block);

/// Name of the bolt with index `bolt`; empty if the index does not refer to a bolt.
std::string boltName(const Scene& scene, int bolt);

/// Name of the stage with index `stage`; empty if the index does not refer to a stage.
std::string stageName(const Scene& scene, int stage);

/// Name of a stage, preceded by the word "stage" unless the name already begins with it: "stage release", "stage 4";
/// empty if the index does not refer to a stage.
std::string stageTitle(const Scene& scene, int stage);

}  // namespace keyblock
