// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Storage of a frame in the run store as rows of doubles: one BLOB each for the
// blocks, their corners, the contacts, the bolt nodes and the bolts, five for single
// forces on the blocks, one for the largest forces in the bolts and one for the
// extremes of the blocks. The lists of columns are also written to every store, so
// that a reader in another language needs nothing but the store.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <span>
#include <string_view>
#include <vector>

namespace keyblock {

/// Name, unit and meaning of one value of a row.
struct PayloadColumn {
    std::string_view name;
    std::string_view unit;  // empty: a pure number, an index or a code
    std::string_view meaning;
};

enum class Payload {
    Blocks, Corners, Contacts, Nodes, Bolts, Weights, Inertia, ContactForces, NodeForces, OtherForces, BoltExtremes,
    BlockExtremes
};

/// Names of the payloads in the store, in the order of `Payload`.
std::span<const std::string_view> payloadWords();

/// Columns of a row of this payload, in the order in which their values are stored.
std::span<const PayloadColumn> payloadColumns(Payload payload);

/// Values of all rows of this payload in a frame, one row after another.
std::vector<double> pack(Payload payload, const Frame& frame);

/// Sets the data of a frame from the rows of a payload. The blocks must be unpacked before all other payloads, bolts
/// before nodes, contacts before contact forces, and weights before inertia.
/// \param values the values of all rows, as returned by `pack`.
/// \param corners the number of corners of each solved block.
/// \return false if the values do not match the scene, its solved blocks or the columns.
bool unpack(Payload payload, std::span<const double> values, const Scene& scene, std::span<const std::size_t> corners,
            Frame& frame);

}  // namespace keyblock
