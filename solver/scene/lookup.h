// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The objects of a scene refer to each other by name and place. This follows
// those references, in one way for the check, the engine and the tables.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <string_view>

namespace keyblock {

/// Places lie no farther from the origin in x and y [m]; beyond, nothing of a tunnel is left in the digits of a double.
inline constexpr double farthestCoordinate = 1e9;

/// True when both coordinates are finite and not too far.
bool isUsable(const Point& place);

/// Diagonal of the box around the domain and all blocks, of those corners that are usable [m]; 1 without any.
double sceneSize(const Scene& scene);

/// Below this distance two points are one, and a point is on an edge [m]: 1e-9 of the scene's size,
/// but never less than what doubles resolve at the scene's distance from the origin.
double geometricTolerance(const Scene& scene);

/// Index of the block that holds `place`; −1 when none does or it lies on a boundary within the geometric tolerance.
int blockAt(const Scene& scene, const Point& place);

/// The same with a known tolerance [m], for many places.
int blockAt(const Scene& scene, const Point& place, double tolerance);

/// Index of a block that holds `point` inside or on its boundary, the first in order; −1 when none does.
int blockWithPoint(const Scene& scene, const Point& point);

/// \pre the scene was checked without errors.
const Material& materialOf(const Scene& scene, const Block& block);

/// Index of the block's joint material: its own, else the scene's first; −1: the built-in one.
/// \pre the scene was checked without errors.
int jointMaterialIndex(const Scene& scene, const Block& block);

/// The material at an index from `jointMaterialIndex`; −1 gives the built-in one.
const JointMaterial& jointMaterialAt(const Scene& scene, int index);

/// The type of that name; null when there is none.
const BoltType* findBoltType(const Scene& scene, std::string_view name);

/// \pre the scene was checked without errors.
const BoltType& boltTypeOf(const Scene& scene, const Bolt& bolt);

/// The bolt's own anchors, else those of its type.
/// \pre the scene was checked without errors.
const std::vector<Anchor>& anchorsOf(const Scene& scene, const Bolt& bolt);

/// The bolt's plane length [m].
double lengthOf(const Bolt& bolt);

/// Metres from the far end of a place along a bolt of `length` [m].
double distanceAlong(const BoltPlace& place, double length);

/// Metres from the far end at which a monitor records a bolt of `length` [m]; its head when it names no place.
double distanceAlong(const Monitor& monitor, double length);

/// `CutFace::source` of the joint of that name, else of the joint set; −1: neither.
/// \pre the scene is not cut yet.
int traceSource(const Scene& scene, std::string_view name);

/// True where the face lies on that side of the domain; on any, where all are requested.
bool isOnSide(const CutFace& face, BoundarySide side);

/// Where a scene file says a bolt: `/bolts/N`, or `/bolt_patterns/N` of one that a pattern gives.
std::string boltPointer(const Scene& scene, std::size_t bolt);

/// The same of a block: `/blocks/N`, or `/domain` of one that was cut.
std::string blockPointer(const Scene& scene, std::size_t block);

/// The block's name, or b1, b2, … by its order when it has none.
/// \pre 0 ≤ block < number of blocks.
std::string displayName(const Scene& scene, int block);

}  // namespace keyblock
