// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words that scene files use for the values of enumerations. Each list is in the
// order of the enumerators and is selected by the type of the value. The words of anchor
// laws and bolt quantities come from the tables of those.
#pragma once

#include "solver/scene/quantity_text.h"
#include "solver/scene/scene.h"
#include "solver/scene/translatable.h"

#include <array>
#include <span>
#include <string_view>

namespace keyblock {

using Words = std::span<const std::string_view>;

inline constexpr std::array<std::string_view, 2> planeWords{"stress", "strain"};
inline constexpr std::array<std::string_view, 4> integrationWords{"shi", "backward-euler", "newmark",
                                                                     "generalized-alpha"};
inline constexpr std::array<std::string_view, 2> iterationWords{"convex", "open-close"};
inline constexpr std::array<std::string_view, 2> contactMethodWords{"penalty", "augmented-lagrangian"};
inline constexpr std::array<std::string_view, 4> presetWords{"sketch", "draft", "engineering", "reference"};
inline constexpr std::array<std::string_view, 4> fixWords{"all", "x", "y", "xy"};
inline constexpr std::array<std::string_view, 2> rotationWords{"held", "free"};
inline constexpr std::array<std::string_view, 2> stageKindWords{"static", "dynamic"};
inline constexpr std::array<std::string_view, 2> onCollapseWords{"end", "dynamic"};
inline constexpr std::array<std::string_view, 4> boltClassWords{"CMC", "CFC", "DMC", "DFC"};
inline constexpr std::array<std::string_view, 3> bendingWords{"none", "elastic", "elastic-plastic"};
inline constexpr std::array<std::string_view, 2> perWords{"node", "length"};
inline constexpr std::array<std::string_view, 2> afterCurveWords{"last", "zero"};
inline constexpr std::array<std::string_view, 2> onFailureWords{"none", "bolt-lost"};
inline constexpr std::array<std::string_view, 2> ruptureRuleWords{"independent", "interaction"};
inline constexpr std::array<std::string_view, 3> plateKindWords{"none", "spring", "block"};
inline constexpr std::array<std::string_view, 5> boundarySideWords{"left", "right", "bottom", "top", "all"};
inline constexpr std::array<std::string_view, 5> profileKindWords{"circle", "d-shape", "horseshoe", "arched", "polygon"};
inline constexpr std::array<std::string_view, 3> reduceWords{"joints", "bonds", "both"};
inline constexpr std::array<std::string_view, 2> boltForcesWords{"mobilised", "frozen"};
inline constexpr std::array<std::string_view, 2> wayWords{"ccw", "cw"};

// Labels shown to the user instead of the words of the file.
inline constexpr std::array<std::string_view, 4> integrationLabels{
    translatable("Fields", "Shi"), translatable("Fields", "backward Euler"), translatable("Fields", "Newmark"),
    translatable("Fields", "generalised α")};
inline constexpr std::array<std::string_view, 2> iterationLabels{translatable("Fields", "convex"),
                                                                 translatable("Fields", "open–close")};
inline constexpr std::array<std::string_view, 2> contactMethodLabels{translatable("Fields", "penalty"),
                                                                     translatable("Fields", "augmented Lagrangian")};
inline constexpr std::array<std::string_view, 2> rotationLabels{translatable("Fields", "fixed"),
                                                                translatable("Fields", "free")};
inline constexpr std::array<std::string_view, 2> onFailureLabels{translatable("Fields", "none"),
                                                                 translatable("Fields", "bolt lost")};
inline constexpr std::array<std::string_view, 5> profileKindLabels{
    translatable("Fields", "circle"), translatable("Fields", "D-shape"), translatable("Fields", "horseshoe"),
    translatable("Fields", "arched"), translatable("Fields", "polygon")};
inline constexpr std::array<std::string_view, 2> wayLabels{translatable("Fields", "counter-clockwise"),
                                                           translatable("Fields", "clockwise")};

constexpr Words wordsOf(Plane) { return planeWords; }
constexpr Words wordsOf(Integration) { return integrationWords; }
constexpr Words wordsOf(Iteration) { return iterationWords; }
constexpr Words wordsOf(ContactMethod) { return contactMethodWords; }
constexpr Words wordsOf(Preset) { return presetWords; }
constexpr Words wordsOf(Fix) { return fixWords; }
constexpr Words wordsOf(Rotation) { return rotationWords; }
constexpr Words wordsOf(StageKind) { return stageKindWords; }
constexpr Words wordsOf(OnCollapse) { return onCollapseWords; }
constexpr Words wordsOf(BoltClass) { return boltClassWords; }
constexpr Words wordsOf(Bending) { return bendingWords; }
constexpr Words wordsOf(Per) { return perWords; }
constexpr Words wordsOf(AnchorLaw) { return anchorLawWords; }
constexpr Words wordsOf(AfterCurve) { return afterCurveWords; }
constexpr Words wordsOf(OnFailure) { return onFailureWords; }
constexpr Words wordsOf(RuptureRule) { return ruptureRuleWords; }
constexpr Words wordsOf(PlateKind) { return plateKindWords; }
constexpr Words wordsOf(BoundarySide) { return boundarySideWords; }
constexpr Words wordsOf(ProfileKind) { return profileKindWords; }
constexpr Words wordsOf(Reduce) { return reduceWords; }
constexpr Words wordsOf(BoltForces) { return boltForcesWords; }
constexpr Words wordsOf(Way) { return wayWords; }
constexpr Words wordsOf(BoltQuantity) { return boltQuantityWords; }

/// Labels shown to the user instead of the words, in the same order; empty if the words themselves are shown.
template <typename Enumeration>
constexpr Words labelsOf(Enumeration) {
    return {};
}
constexpr Words labelsOf(Integration) { return integrationLabels; }
constexpr Words labelsOf(Iteration) { return iterationLabels; }
constexpr Words labelsOf(ContactMethod) { return contactMethodLabels; }
constexpr Words labelsOf(Rotation) { return rotationLabels; }
constexpr Words labelsOf(AnchorLaw) { return anchorLawTitles; }
constexpr Words labelsOf(OnFailure) { return onFailureLabels; }
constexpr Words labelsOf(ProfileKind) { return profileKindLabels; }
constexpr Words labelsOf(Way) { return wayLabels; }

}  // namespace keyblock
