// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a frame lies in the run store: rows of doubles, one BLOB for the blocks, one
// for their corners, one for the contacts, one for the bolts' nodes, one for the
// bolts, five for single forces on the blocks, one for the largest forces in the
// bolts and one for the extremes of the blocks. The lists of columns here are also written into every store, so that a
// reader in another language needs nothing but the store.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <span>
#include <string_view>
#include <vector>

namespace keyblock {

/// One value of a row: its name, its unit and what it means.
struct PayloadColumn {
    std::string_view name;
    std::string_view unit;  // empty: a number, an index or a code
    std::string_view meaning;
};

enum class Payload {
    Blocks, Corners, Contacts, Nodes, Bolts, Weights, Inertia, ContactForces, NodeForces, OtherForces, BoltExtremes,
    BlockExtremes
};

/// The payloads' names in the store, in the order of `Payload`.
std::span<const std::string_view> payloadWords();

/// The values of one row of a payload, in order.
std::span<const PayloadColumn> payloadColumns(Payload payload);

/// The rows of a payload, one after another.
std::vector<double> pack(Payload payload, const Frame& frame);

/// Puts the rows of a payload into a frame: blocks before corners, bolts before nodes, forces last. False when they do not fit
/// the scene, the number of blocks that are solved, or the columns.
bool unpack(Payload payload, std::span<const double> values, const Scene& scene, std::size_t blocks, Frame& frame);

}  // namespace keyblock
