// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Design data for every bolt of a run: its largest forces, the utilisation of its
// strengths, the strength that governs, and the blocks that it supports.
#pragma once

#include "solver/results/run_source.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The strengths of a bolt, in the order in which they are listed in the output.
enum class BoltStrength { Steel, Shear, Bond, Plate };

struct BoltStrengthRow {
    BoltStrength strength;
    std::string_view key;  // in JSON output
    std::string_view title;  // for display
    BoltPeak BoltExtremes::*use;
};

/// All strengths, in the order of `BoltStrength`.
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
    /// Highest utilisation of each strength over the run, in the order of `BoltStrength`; none if the bolt has no such
    /// strength.
    std::array<std::optional<double>, boltStrengths.size()> use;
    std::optional<BoltStrength> governs;  // highest utilisation; none if the bolt has no strength or carried no force
    /// Indices in the frames of the blocks that the bolt crossed when it was installed, in order from its head, without
    /// the block that contains its far end. A block divided into cells has the index of its first cell.
    std::vector<int> holds;

    double highest() const { return governs ? *use[static_cast<std::size_t>(*governs)] : 0.0; }
};

/// Utilisation of the bolt with index `bolt`, from its extremes; `holds` is left empty.
BoltUse boltUse(int bolt, const BoltExtremes& extremes);

/// The governing strength and its utilisation, as in "bond used to 87 %" or "steel used to 9.1 % of ultimate strength";
/// empty if no strength governs.
std::string useText(const BoltUse& use);

/// Nodes of the bolts in the first frame after their installation, indexed by bolt and node; no nodes for a bolt that
/// has not been installed yet.
std::vector<std::vector<BoltNodeFrame>> boltsAsInstalled(const RunSource& run);

/// Design data of all bolts of the scene, indexed by bolt; empty for a run without frames or a store without bolt
/// extremes.
std::vector<BoltUse> boltUses(const RunSource& run);

}  // namespace keyblock
