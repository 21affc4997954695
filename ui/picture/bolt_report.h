// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a designer asks of one bolt at a moment of a run: its state in one word, how
// much of its bond is left, and its use of strengths so far.
#pragma once

#include "solver/results/bolt_use.h"

#include <span>
#include <string_view>

namespace keyblock {

/// In order of gravity.
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
    double plateForce = 0.0;  // at this moment [N]
    BoltUse use;  // over the run until this moment

    bool isInstalled() const { return condition != BoltCondition::NotInstalled; }
};

/// \param events those of the run until the frame. \pre the bolt is a row of the scene and of the frame.
BoltReport boltReport(const Scene& scene, const Frame& frame, int bolt, std::span<const Event> events);

}  // namespace keyblock
