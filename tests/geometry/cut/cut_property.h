// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must hold of every cut, however degenerate its traces, and random sections
// to show it on.
#pragma once

#include "geometry/cut/cut.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct CutInput {
    std::vector<CutDomain> domains;
    std::vector<CutTrace> traces;
    CutSettings settings;
};

Cut cutIntoBlocks(const CutInput& input);

/// The same input in another order, with outlines and some traces the other way round and some traces twice.
CutInput shuffled(const CutInput& input, std::uint64_t seed);

/// The corners of a ring [m].
std::vector<Point> outlineOf(const Cut& cut, const CutRing& ring);

/// Blocks tile the domains, rings are simple and rightly turned, no block is under a limit, Euler's formula holds of
/// the blocks with all their vertices, and the shuffled input gives the very same blocks.
/// \return what does not hold; empty where all does.
std::string brokenCut(const CutInput& input);

/// A section with 50 to 2,000 traces; every odd seed gives one that is degenerate on purpose.
CutInput randomSection(std::uint64_t seed);

/// A section made of bytes, degenerate in most cases: ends lie on a coarse lattice, some a hair beside it.
CutInput sectionOfBytes(std::span<const std::uint8_t> bytes);

}  // namespace keyblock
