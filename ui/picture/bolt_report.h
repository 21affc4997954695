// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// State of one bolt at a time of a run: its condition in one word, how much of its bond
// is left, and its utilisation so far.
#pragma once

#include "solver/results/bolt_use.h"

#include <span>
#include <string_view>

namespace keyblock {

/// In order of severity.
enum class BoltCondition {
    NotInstalled, Intact, PartlyDebonded, Debonded, Yielded, PlateLost, Ruptured, PulledOut, Lost
};

/// "not installed", "intact", … "lost".
std::string_view wordOf(BoltCondition condition);

struct BoltReport {
    BoltCondition condition = BoltCondition::NotInstalled;
    int bonded = 0, slipping = 0, failed = 0;  // bonded nodes, by the state of their bond
    double debonded = 0.0;  // length of the bar whose bond slips or has failed [m]
    bool hasPlate = false, plateHolds = false;
    double plateForce = 0.0;  // at this time [N]
    BoltUse use;  // over the run up to this time

    bool isInstalled() const { return condition != BoltCondition::NotInstalled; }
};

/// \param events events of the run up to the frame. \pre the bolt is a row of the scene and of the frame.
BoltReport boltReport(const Scene& scene, const Frame& frame, int bolt, std::span<const Event> events);

}  // namespace keyblock
