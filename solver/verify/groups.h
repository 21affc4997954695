// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The groups of cases in the verification suite, one source file each.
#pragma once

#include "solver/verify/verify.h"

#include <vector>

namespace keyblock {

std::vector<Case> blockCases();
std::vector<Case> schemeCases();
std::vector<Case> cellCases();
std::vector<Case> plateCases();
std::vector<Case> openingCases();
std::vector<Case> roofCases();
std::vector<Case> voussoirCases();
std::vector<Case> toppleCases();
std::vector<Case> waveCases();
std::vector<Case> shakenCases();
std::vector<Case> contactCases();
std::vector<Case> beamCases();
std::vector<Case> bondCases();
std::vector<Case> slidingBoltCases();
std::vector<Case> pullOutCases();
std::vector<Case> dowelCases();
std::vector<Case> stepCases();

}  // namespace keyblock
