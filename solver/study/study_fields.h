// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The field tables of a study, from which its reader, checks, schema and reference
// page are made.
#pragma once

#include "solver/scene/field.h"
#include "solver/study/study.h"

#include <array>
#include <span>
#include <string_view>

namespace keyblock {

inline constexpr std::array<std::string_view, 3> planKindWords{"full-factorial", "latin-hypercube", "monte-carlo"};
inline constexpr std::array<std::string_view, 5> distributionKindWords{"uniform", "triangular", "normal", "lognormal",
                                                                       "seed"};
inline constexpr std::array<std::string_view, 3> faultKindWords{"missing", "bond-lost", "misplaced"};
inline constexpr std::array<std::string_view, 3> bondLossPlaceWords{"anywhere", "far-end", "head"};
inline constexpr std::array<std::string_view, 3> keptStoresWords{"all", "thin", "none"};

inline std::span<const std::string_view> wordsOf(PlanKind) { return planKindWords; }
inline std::span<const std::string_view> wordsOf(DistributionKind) { return distributionKindWords; }
inline std::span<const std::string_view> wordsOf(FaultKind) { return faultKindWords; }
inline std::span<const std::string_view> wordsOf(BondLossPlace) { return bondLossPlaceWords; }
inline std::span<const std::string_view> wordsOf(KeptStores) { return keptStoresWords; }

const Structure& structureOf(const StudyPlan*);
const Structure& structureOf(const StudyRange*);
const Structure& structureOf(const StudyDistribution*);
const Structure& structureOf(const StudyParameter*);
const Structure& structureOf(const StudyFault*);

/// The field table of a study, the root of the others.
const Structure& studyStructure();

/// Largest number of cases of a study.
inline constexpr int mostCases = 1'000'000;

}  // namespace keyblock
