// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The user's choice of the colour range of a quantity. Each quantity has its own
// choice, so that a range in MPa is never applied to millimetres.
#pragma once

#include "ui/picture/ticks.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace keyblock {

enum class ScaleOf { AllFrames, ThisFrame, Own };

struct ScaleChoice {
    ScaleOf of = ScaleOf::AllFrames;
    ValueRange own{};  // range for `Own` [MPa, kN, mm]; low < high
    bool clips = false;  // excludes the extreme values of blocks: 2 % of the area at each end of the range
    int intervals = 0;  // number of equal colour steps; 0: continuous colours

    bool operator==(const ScaleChoice&) const = default;
};

/// The user's choices, keyed by the name of the quantity.
using ScaleChoices = std::map<std::string, ScaleChoice, std::less<>>;

/// The choice for a quantity; the default if the user has made none.
inline ScaleChoice scaleOf(const ScaleChoices& choices, std::string_view quantity) {
    const auto found = choices.find(quantity);
    return found == choices.end() ? ScaleChoice{} : found->second;
}

}  // namespace keyblock
