// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each list is in the order of its enumeration, which the tests check.
#include "solver/results/result_names.h"

#include "solver/scene/lookup.h"
#include "solver/scene/enum_names.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 8> outcomeWords{"equilibrium", "duration", "limit",     "collapse",
                                                       "stopped",     "failed",   "displaced", "undecided"};
constexpr std::array<std::string_view, 4> movementWords{"slides", "falls", "topples", "follows"};
constexpr std::array<std::string_view, 4> nodeStateWords{"bonded", "slipping", "gone", "free"};
constexpr std::array<std::string_view, 4> contactStateWords{"open", "sliding", "locked", "bonded"};

constexpr std::array<std::string_view, 9> forceSourceWords{"weight", "contact", "bolt",    "support", "load",
                                                           "wall",   "glue",    "dashpot", "inertia"};

template <typename Value, typename Words>
std::optional<Value> valueOf(const Words& words, std::string_view word) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end())
        return std::nullopt;
    return static_cast<Value>(found - words.begin());
}

template <typename Item>
bool holds(const std::vector<Item>& items, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < items.size();
}

}  // namespace

std::string_view wordOf(EventKind kind) { return rowOf(kind).key; }
std::string_view wordOf(Outcome outcome) { return outcomeWords[static_cast<std::size_t>(outcome)]; }
std::string_view wordOf(Movement mode) { return movementWords[static_cast<std::size_t>(mode)]; }
std::string_view wordOf(NodeState state) { return nodeStateWords[static_cast<std::size_t>(state)]; }
std::string_view wordOf(ContactState state) { return contactStateWords[static_cast<std::size_t>(state)]; }
std::string_view wordOf(ForceSource source) { return forceSourceWords[static_cast<std::size_t>(source)]; }
std::string_view wordOf(StageKind kind) { return stageKindWords[static_cast<std::size_t>(kind)]; }
std::string_view anchorWord(bool real) { return real ? "real" : "artificial"; }

std::optional<EventKind> eventKindOf(std::string_view word) {
    const auto row = std::ranges::find(eventKinds, word, &EventKindRow::key);
    if (row == eventKinds.end()) return std::nullopt;
    return row->kind;
}

std::optional<Outcome> outcomeOf(std::string_view word) { return valueOf<Outcome>(outcomeWords, word); }

std::string blockName(const std::vector<std::string>& names, int block) {
    return holds(names, block) ? names[block] : "";
}

std::string boltName(const Scene& scene, int bolt) { return holds(scene.bolts, bolt) ? scene.bolts[bolt].name : ""; }

std::string stageName(const Scene& scene, int stage) {
    return holds(scene.stages, stage) ? scene.stages[stage].name : "";
}

std::string stageTitle(const Scene& scene, int stage) {
    const std::string name = stageName(scene, stage);
    const bool says = name.starts_with("stage") || name.starts_with("Stage");
    return name.empty() || says ? name : "stage " + name;
}

}  // namespace keyblock
