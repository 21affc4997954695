// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The user's choice of colour range for a quantity. Every quantity has its own choice,
// so that a range in MPa is never applied to millimetres.
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
    ValueRange own{};  // of `Own`, in units of pictures [MPa, kN, mm]; low < high
    bool clips = false;  // excludes the extreme values of blocks, 2 % of the area at either end
    int intervals = 0;  // equal steps of colour; 0: without steps

    bool operator==(const ScaleChoice&) const = default;
};

/// By the name of the quantity.
using ScaleChoices = std::map<std::string, ScaleChoice, std::less<>>;

/// The choice for the quantity; the default if the user has made none.
inline ScaleChoice scaleOf(const ScaleChoices& choices, std::string_view quantity) {
    const auto found = choices.find(quantity);
    return found == choices.end() ? ScaleChoice{} : found->second;
}

}  // namespace keyblock
