// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a designer needs of every bolt of a run: its largest forces, how much of its
// strengths they use, which of them governs, and which rock it holds.
#pragma once

#include "solver/results/run_source.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The strengths of a bolt, in the order in which answers list them.
enum class BoltStrength { Steel, Shear, Bond, Plate };

struct BoltStrengthRow {
    BoltStrength strength;
    std::string_view key;  // in answers
    std::string_view title;  // as users read it
    BoltPeak BoltExtremes::*use;
};

/// In the order of `BoltStrength`.
inline constexpr std::array boltStrengths{
    BoltStrengthRow{BoltStrength::Steel, "steel", "Steel", &BoltExtremes::steel},
    BoltStrengthRow{BoltStrength::Shear, "shear", "Shear", &BoltExtremes::shear},
    BoltStrengthRow{BoltStrength::Bond, "bond", "Bond", &BoltExtremes::bond},
    BoltStrengthRow{BoltStrength::Plate, "plate", "Face plate", &BoltExtremes::plate}};

constexpr const BoltStrengthRow& rowOf(BoltStrength strength) {
    return boltStrengths.at(static_cast<std::size_t>(strength));
}

struct BoltUse {
    int bolt = -1;
    BoltExtremes extremes;
    /// Highest use over the run, in the order of `BoltStrength`; none: no such strength, or never installed.
    std::array<std::optional<double>, boltStrengths.size()> use;
    std::optional<BoltStrength> governs;  // the one used most; none: nothing limits the bolt, or it carried no force
    /// First rows of the blocks that the bolt passed when it was installed, from its head on, without the block that
    /// holds its far end.
    std::vector<int> holds;

    double highest() const { return governs ? *use[static_cast<std::size_t>(*governs)] : 0.0; }
};

/// Without the blocks that it holds.
BoltUse boltUse(int bolt, const BoltExtremes& extremes);

/// The strength that governs, as in "bond used to 87 %"; empty where none does.
std::string useText(const BoltUse& use);

/// Nodes of every bolt as it was first seen, when it was installed; none of a bolt that no stage so far has installed.
std::vector<std::vector<BoltNodeFrame>> boltsAsInstalled(const RunSource& run);

/// A row per bolt of the scene; none of a run without frames or of a store without extremes.
std::vector<BoltUse> boltUses(const RunSource& run);

}  // namespace keyblock
