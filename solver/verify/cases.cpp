// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/groups.h"

namespace keyblock {

namespace {

std::vector<Case> allGroups() {
    std::vector<Case> all;
    for (const auto& group : {blockCases(), contactCases(), schemeCases(), shakenCases(), cellCases(), plateCases(),
                              openingCases(), roofCases(), voussoirCases(), toppleCases(), waveCases(), beamCases(),
                              bondCases(), slidingBoltCases(), pullOutCases(), dowelCases(), stepCases()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

}  // namespace

const std::vector<Case>& cases() {
    static const std::vector<Case> all = allGroups();
    return all;
}

}  // namespace keyblock
