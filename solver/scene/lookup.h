// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Objects of a scene refer to each other by name and by position. These functions
// resolve such references for the check, the engine and the tables.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <string_view>

namespace keyblock {

/// Largest absolute value of a coordinate [m]. Beyond it, doubles are too coarse for the dimensions of a tunnel.
inline constexpr double farthestCoordinate = 1e9;

/// True if both coordinates are finite and their absolute values do not exceed `farthestCoordinate`.
bool isUsable(const Point& place);

/// Diagonal [m] of the bounding box of the domain and all blocks, ignoring corners that are not usable (see
/// `isUsable`); 1 if the diagonal is zero.
double sceneSize(const Scene& scene);

/// Distance [m] within which two points coincide, or a point lies on an edge: 1e-9 of the scene's size, but at least
/// the resolution of doubles at the scene's distance from the origin.
double geometricTolerance(const Scene& scene);

/// Index of the block with `place` in its interior; −1 if there is none. Points within the geometric tolerance of a
/// block's boundary are not in its interior.
int blockAt(const Scene& scene, const Point& place);

/// Like the overload above, with a given tolerance [m]; faster for many points.
int blockAt(const Scene& scene, const Point& place, double tolerance);

/// Index of the first block that contains `point`, inside or on its boundary; −1 if there is none.
int blockWithPoint(const Scene& scene, const Point& point);

/// \pre the scene has been checked and has no errors.
const Material& materialOf(const Scene& scene, const Block& block);

/// Index of the block's joint material in `scene.jointMaterials`: that of the material named by the block or, if it
/// names none, 0. If the scene has no joint materials, −1; the built-in material then applies.
/// \pre the scene has been checked and has no errors.
int jointMaterialIndex(const Scene& scene, const Block& block);

/// The joint material for an index from `jointMaterialIndex`; a negative index gives the built-in material.
const JointMaterial& jointMaterialAt(const Scene& scene, int index);

/// The bolt type with this name; null if there is none.
const BoltType* findBoltType(const Scene& scene, std::string_view name);

/// \pre the scene has been checked and has no errors.
const BoltType& boltTypeOf(const Scene& scene, const Bolt& bolt);

/// The bolt's own anchors or, if it has none, the anchors of its type.
/// \pre the scene has been checked and has no errors.
const std::vector<Anchor>& anchorsOf(const Scene& scene, const Bolt& bolt);

/// Length of the bolt in the plane [m].
double lengthOf(const Bolt& bolt);

/// Distance [m] of a position from the far end of a bolt. \param length length of the bolt [m]
double distanceAlong(const BoltPlace& place, double length);

/// Distance [m] from the far end of a bolt to the position at which a monitor records. A monitor without a position
/// records at the head.
/// \param length length of the bolt [m]
double distanceAlong(const Monitor& monitor, double length);

/// Value of `CutFace::source` for the joint with this name or, if there is none, for the joint set with this name; −1
/// if there is neither.
/// \pre the scene has not been cut yet.
int traceSource(const Scene& scene, std::string_view name);

/// True if the face lies on this side of the domain; for `BoundarySide::All`, if it lies on any side.
bool isOnSide(const CutFace& face, BoundarySide side);

/// JSON pointer to the definition of the bolt with the index `bolt`: `/bolts/N`, where N is this index. For a bolt of a
/// pattern: `/bolt_patterns/N`, where N is the index of the pattern.
std::string boltPointer(const Scene& scene, std::size_t bolt);

/// JSON pointer to the definition of the block with the index `block`: `/blocks/N`, where N is this index. For a block
/// cut from the domain: `/domain`.
std::string blockPointer(const Scene& scene, std::size_t block);

/// Name of the block with the index `block`. If it has none, `b` followed by its number in the list of blocks, starting
/// at 1.
/// \pre 0 ≤ block < number of blocks.
std::string displayName(const Scene& scene, int block);

}  // namespace keyblock
