// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// There are few names, so they are searched linearly. Points are looked up
// block by block; bounding boxes are tested first.
#include "solver/scene/lookup.h"

#include "geometry/polygon.h"
#include "solver/scene/pointer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

constexpr double relativeTolerance = 1e-9;  // ratio to the size of the scene
constexpr double resolution = 8.0 * std::numeric_limits<double>::epsilon();  // ratio to the largest coordinate

Box boxOfScene(const Scene& scene) {
    std::vector<Point> corners;
    for (const Block& block : scene.blocks)
        std::copy_if(block.points.begin(), block.points.end(), std::back_inserter(corners),
                     isUsable);
    if (scene.domain)
        std::copy_if(scene.domain->boundary.begin(), scene.domain->boundary.end(), std::back_inserter(corners),
                     isUsable);
    return corners.empty() ? Box{} : boxOf(corners);
}

int findBlock(const Scene& scene, const Point& place, double tolerance, bool boundaryCounts) {
    for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
        const std::vector<Point>& points = scene.blocks[i].points;
        if (points.empty() || !meets(grown(boxOf(points), tolerance), Box{place, place}))
            continue;
        const Side side = locate(points, place, tolerance);
        if (side == Side::Inside || (boundaryCounts && side == Side::Boundary))
            return static_cast<int>(i);
    }
    return -1;
}

template <typename Pairs>
int indexOfPair(const Pairs& pairs, const std::string& key) {
    const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.first == key; });
    return found == pairs.end() ? -1 : static_cast<int>(found - pairs.begin());
}

}  // namespace

bool isUsable(const Point& place) {
    return place.allFinite() && place.cwiseAbs().maxCoeff() <= farthestCoordinate;
}

double sceneSize(const Scene& scene) {
    const Box box = boxOfScene(scene);
    const double diagonal = (box.max - box.min).norm();
    return diagonal > 0.0 ? diagonal : 1.0;
}

double geometricTolerance(const Scene& scene) {
    const Box box = boxOfScene(scene);
    const double farthest = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
    return std::max(relativeTolerance * sceneSize(scene), resolution * farthest);
}

int blockAt(const Scene& scene, const Point& place) { return blockAt(scene, place, geometricTolerance(scene)); }

int blockAt(const Scene& scene, const Point& place, double tolerance) {
    return findBlock(scene, place, tolerance, false);
}

int blockWithPoint(const Scene& scene, const Point& point) {
    return findBlock(scene, point, geometricTolerance(scene), true);
}

const Material& materialOf(const Scene& scene, const Block& block) {
    return scene.materials.at(static_cast<std::size_t>(indexOfPair(scene.materials, block.material))).second;
}

int jointMaterialIndex(const Scene& scene, const Block& block) {
    if (block.jointMaterial)
        return indexOfPair(scene.jointMaterials, *block.jointMaterial);
    return scene.jointMaterials.empty() ? -1 : 0;
}

const JointMaterial& jointMaterialAt(const Scene& scene, int index) {
    return index < 0 ? builtInJointMaterial : scene.jointMaterials.at(static_cast<std::size_t>(index)).second;
}

const BoltType* findBoltType(const Scene& scene, std::string_view name) {
    const auto found = std::find_if(scene.boltTypes.begin(), scene.boltTypes.end(),
                                    [&](const BoltType& type) { return type.name == name; });
    return found == scene.boltTypes.end() ? nullptr : &*found;
}

const BoltType& boltTypeOf(const Scene& scene, const Bolt& bolt) { return *findBoltType(scene, bolt.type); }

const std::vector<Anchor>& anchorsOf(const Scene& scene, const Bolt& bolt) {
    return bolt.anchors ? *bolt.anchors : boltTypeOf(scene, bolt).anchors;
}

double lengthOf(const Bolt& bolt) { return (bolt.head - bolt.farEnd).norm(); }

double distanceAlong(const BoltPlace& place, double length) { return place.head ? length : place.s; }

double distanceAlong(const Monitor& monitor, double length) {
    if (monitor.at)
        return *monitor.at;
    if (monitor.atFraction)
        return *monitor.atFraction * length;
    return length - monitor.atFromHead.value_or(0.0);
}

int traceSource(const Scene& scene, std::string_view name) {
    if (name.empty()) return -1;
    const auto isIt = [&](const auto& item) { return item.name == name; };
    const auto joint = std::find_if(scene.joints.begin(), scene.joints.end(), isIt);
    if (joint != scene.joints.end()) return static_cast<int>(joint - scene.joints.begin());
    const auto set = std::find_if(scene.jointSets.begin(), scene.jointSets.end(), isIt);
    if (set == scene.jointSets.end()) return -1;
    return static_cast<int>(scene.joints.size()) + static_cast<int>(set - scene.jointSets.begin());
}

bool isOnSide(const CutFace& face, BoundarySide side) {
    return face.side && (side == BoundarySide::All || side == *face.side);
}

std::string boltPointer(const Scene& scene, std::size_t bolt) {
    const int pattern = scene.bolts[bolt].pattern;
    return pattern < 0 ? under("/bolts", bolt) : under("/bolt_patterns", static_cast<std::size_t>(pattern));
}

std::string blockPointer(const Scene& scene, std::size_t block) {
    return scene.blocks[block].faces.empty() ? under("/blocks", block) : "/domain";
}

std::string displayName(const Scene& scene, int block) {
    assert(0 <= block && block < static_cast<int>(scene.blocks.size()));
    const std::string& name = scene.blocks.at(static_cast<std::size_t>(block)).name;
    return name.empty() ? "b" + std::to_string(block + 1) : name;
}

}  // namespace keyblock
