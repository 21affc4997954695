// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// State of one bolt at a given time of a run: its condition in one word, how much of
// its bond remains, and its utilisation to date.
#pragma once

#include "solver/results/bolt_use.h"

#include <span>
#include <string_view>

namespace keyblock {

/// Condition of a bolt, from least to most severe.
enum class BoltCondition {
    NotInstalled, Intact, PartlyDebonded, Debonded, Yielded, PlateLost, Ruptured, PulledOut, Lost
};

/// A condition in words, such as "not installed", "intact" or "lost".
std::string_view wordOf(BoltCondition condition);

struct BoltReport {
    BoltCondition condition = BoltCondition::NotInstalled;
    int bonded = 0, slipping = 0, failed = 0;  // number of anchored nodes whose bond is intact, slipping or failed
    double debonded = 0.0;  // length of bar over which the bond slips or has failed [m]
    bool hasPlate = false, plateHolds = false;
    double plateForce = 0.0;  // force on the face plate at this time [N]
    BoltUse use;  // utilisation over the run up to this time

    bool isInstalled() const { return condition != BoltCondition::NotInstalled; }
};

/// State of a bolt in a frame. \param events the events of the run up to the frame.
/// \pre `bolt` is a valid index into the bolts of both the scene and the frame.
BoltReport boltReport(const Scene& scene, const Frame& frame, int bolt, std::span<const Event> events);

}  // namespace keyblock
