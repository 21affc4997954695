// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks have to be valid before anything can be looked up in them, so their
// outlines are checked one by one first, then all pairs for overlap, and then
// their supports.
#include "geometry/grid.h"
#include "geometry/polygon.h"
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/stage_objects.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace keyblock {

namespace {

constexpr double roundOff = 1e-9;  // ratio to the largest stress

bool areUsable(const std::vector<Point>& points) {
    return std::all_of(points.begin(), points.end(), isUsable);  // otherwise already reported by the field check
}

// Index of a corner that coincides with the previous one (for the first corner: with the last); −1 if there is none.
int repeatedCorner(const std::vector<Point>& points, double tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& before = points[(i + points.size() - 1) % points.size()];
        if ((points[i] - before).norm() <= tolerance)
            return static_cast<int>(i);
    }
    return -1;
}

bool lieOnOneLine(const std::vector<Point>& points, double tolerance) {
    const auto distance = [&](const Point& point) { return (point - points[0]).norm(); };
    const Point farthest = *std::max_element(
        points.begin(), points.end(), [&](const Point& a, const Point& b) { return distance(a) < distance(b); });
    const Point direction = (farthest - points[0]).normalized();
    return std::all_of(points.begin(), points.end(),
                       [&](const Point& point) { return std::abs(cross(direction, point - points[0])) <= tolerance; });
}

bool checkRepeatedCorner(const std::vector<Point>& points, const std::string& pointer, double tolerance,
                         CheckReport& report) {
    const int corner = repeatedCorner(points, tolerance);
    if (corner < 0)
        return true;
    const std::string place = under(pointer, corner == 0 ? points.size() - 1 : static_cast<std::size_t>(corner));
    if (corner == 0)
        report.error(place, "the last corner repeats the first", "Remove it: outlines are closed automatically",
                     {RepairKind::Omit, place});
    else
        report.error(place, "the corner repeats the one before it", "Remove it", {RepairKind::Omit, place});
    return false;
}

}  // namespace

bool checkOutline(const std::vector<Point>& points, const std::string& pointer, std::string_view what,
                  double tolerance, CheckReport& report) {
    if (!areUsable(points))
        return false;
    if (points.size() < 3) {
        report.error(pointer, std::string(what) + " has " + std::to_string(points.size()) + " corners",
                     "Give at least three");
        return false;
    }
    if (points.size() > mostCorners) {
        report.error(pointer,
                     std::string(what) + " has " + std::to_string(points.size()) + " corners; the limit is " +
                         std::to_string(mostCorners),
                     "Omit corners that hardly change the outline; an import makes fewer with a larger sagitta");
        return false;
    }
    if (!checkRepeatedCorner(points, pointer, tolerance, report))
        return false;
    if (lieOnOneLine(points, tolerance)) {
        report.error(pointer, std::string(what) + " has no area", "Give corners that do not all lie on one line");
        return false;
    }
    if (const auto place = crossesItself(points, tolerance)) {
        report.error(pointer,
                     "the outline crosses itself or runs back along itself at (" + coordinateText(place->x()) + ", " +
                         coordinateText(place->y()) + ")",
                     "Give the corners in order round " + std::string(what) + ", or split it in two");
        return false;
    }
    return true;
}

namespace {

void checkOverlap(std::size_t a, std::size_t b, CheckContext& context) {
    if (overlap(context.scene.blocks[a].points, context.scene.blocks[b].points, context.tolerance))
        context.report.error(under("/blocks", b),
                             "the block " + inQuotes(displayName(context.scene, static_cast<int>(b))) + " overlaps " +
                                 inQuotes(displayName(context.scene, static_cast<int>(a))),
                             "Move corners so that the two blocks do not overlap; they may touch");
}

void checkOverlaps(CheckContext& context) {
    std::vector<std::size_t> blocks;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < context.scene.blocks.size(); ++i) {
        if (!context.sound[i] || !context.scene.blocks[i].faces.empty())
            continue;  // cut blocks do not overlap
        blocks.push_back(i);
        boxes.push_back(boxOf(context.scene.blocks[i].points));
    }
    if (boxes.empty())
        return;
    const BoxGrid grid(boxes);
    for (std::size_t first = 0; first < boxes.size(); ++first)
        for (const int second : grid.meeting(boxes[first])) {
            if (context.report.isFull()) return;
            if (static_cast<std::size_t>(second) > first)
                checkOverlap(blocks[first], blocks[static_cast<std::size_t>(second)], context);
        }
}

/// The names to which blocks refer, for scenes with thousands of both.
struct RockNames {
    explicit RockNames(const Scene& scene)
        : materials(namesOf(scene.materials)), joints(namesOf(scene.jointMaterials)) {}

    std::vector<std::string_view> materials, joints;
    std::unordered_set<std::string_view> knownMaterials{materials.begin(), materials.end()};
    std::unordered_set<std::string_view> knownJoints{joints.begin(), joints.end()};
};

void checkBlock(const Block& block, std::size_t index, const RockNames& names, CheckContext& context) {
    const std::string pointer = under("/blocks", index);
    if (!names.knownMaterials.contains(block.material))
        checkReference(block.material, names.materials, "materials", under(pointer, "material"), context.report);
    if (block.jointMaterial && block.jointMaterial->empty())
        context.report.error(under(pointer, "joint_material"), "the name is empty", "Give a name, or omit it");
    if (block.jointMaterial && !names.knownJoints.contains(*block.jointMaterial))
        checkReference(*block.jointMaterial, names.joints, "joint_materials", under(pointer, "joint_material"),
                       context.report);
    context.sound[index] =
        checkOutline(block.points, under(pointer, "points"), "the block", context.tolerance, context.report);
}

void checkJointMaterial(const JointMaterial& joint, const std::string& pointer, CheckReport& report) {
    if (joint.residualFrictionAngle && *joint.residualFrictionAngle > joint.frictionAngle)
        report.error(under(pointer, "residual_friction_angle"),
                     "friction cannot increase from " + shortest(joint.frictionAngle) + "° to " +
                         shortest(*joint.residualFrictionAngle) + "° by slip",
                     "Give at most the friction angle, or omit it");
}

void checkBlockSupport(const Support& support, const std::string& pointer, CheckContext& context) {
    if (support.fix != Fix::All)
        context.report.error(under(pointer, "fix"), "a whole block can only be fixed in all its unknowns",
                             "Write \"fix\": \"all\", or give \"point\" instead of \"block_at\"");
    const int block = checkBlockAt(context, *support.blockAt, under(pointer, "block_at"));
    if (block >= 0)
        context.fixed[block] = true;
}

void checkBoundarySupport(const Support& support, const std::string& pointer, CheckContext& context) {
    if (!context.document.domain)
        return context.report.error(under(pointer, "boundary"), "the scene has no domain with a boundary to fix",
                                    "Give \"block_at\" or \"point\", or a domain");
    bool any = false;
    for (std::size_t b = 0; b < context.scene.blocks.size(); ++b)
        for (const CutFace& face : context.scene.blocks[b].faces) {
            if (!isOnSide(face, *support.boundary))
                continue;
            any = true;
            if (support.fix == Fix::All)
                context.fixed[b] = true;
        }
    if (!any && context.isCut)
        context.report.error(under(pointer, "boundary"), "no block has a face on that side of the domain",
                             "Give another side: an edge belongs to the side that its outward normal points to");
}

void checkSupport(const Support& support, const std::string& pointer, CheckContext& context) {
    const int places = (support.blockAt ? 1 : 0) + (support.point ? 1 : 0) + (support.boundary ? 1 : 0);
    if (places != 1) {
        context.report.error(pointer, "a support needs exactly one of 'block_at', 'point' and 'boundary'",
                             places > 1 ? "Keep only one of them" : "Give one of them");
        return;
    }
    if (support.boundary)
        return checkBoundarySupport(support, pointer, context);
    if (support.blockAt)
        return checkBlockSupport(support, pointer, context);
    if (support.fix == Fix::All)
        context.report.error(under(pointer, "fix"), "a point can only be fixed in x, y or both",
                             "Write \"fix\": \"x\", \"y\" or \"xy\", or give \"block_at\" instead of \"point\"");
    checkPointOnBlock(context, *support.point, under(pointer, "point"));
}

template <typename Named>
void checkKeysDiffer(const std::vector<std::pair<std::string, Named>>& items, const std::string& list,
                     std::string_view what, CheckReport& report) {
    for (const auto& item : items)
        if (item.first.empty())
            report.error(under(list, ""), "a " + std::string(what) + " has an empty name", "Give it a name");
    checkNamesDiffer(
        items.size(), [&](std::size_t i) { return items[i].first; },
        [&](std::size_t i) { return under(list, items[i].first); }, what, report);
}

// The stress varies linearly with height, so tension is largest at the lowest or the highest point of the rock.
void checkInSituStress(CheckContext& context) {
    const Scene& scene = context.scene;
    if (!scene.inSituStress)
        return;
    for (const auto& [component, key] : {std::pair(0u, "sxx"), std::pair(1u, "syy")}) {
        double most = 0.0, largest = 0.0, height = 0.0;
        for (const Block& block : scene.blocks)
            for (const Point& place : block.points) {
                const double stress = inSituStressAt(scene, place)[component];
                largest = std::max(largest, std::abs(stress));
                if (stress > most)
                    most = stress, height = place.y();
            }
        if (!(most > roundOff * largest) || !std::isfinite(most))
            continue;
        context.report.warning(under("/in_situ_stress", key),
                               "the rock is under tension: " + pressureText(most) + " at y = " + coordinateText(height) + " m",
                               "Tension is positive in a file: give compression as a negative number, and a "
                               "'reference_y' at which the stress is known");
    }
}

}  // namespace

void checkRock(CheckContext& context) {
    const Scene& scene = context.scene;
    checkKeysDiffer(scene.materials, "/materials", "material", context.report);
    checkKeysDiffer(scene.jointMaterials, "/joint_materials", "joint material", context.report);
    for (const auto& [name, joint] : scene.jointMaterials)
        checkJointMaterial(joint, under("/joint_materials", name), context.report);
    checkNamesDiffer(
        scene.blocks.size(), [&](std::size_t i) { return displayName(scene, static_cast<int>(i)); },
        [&](std::size_t i) { return scene.blocks[i].faces.empty() ? under(under("/blocks", i), "name") : "/domain"; },
        "block", context.report);
    context.sound.assign(scene.blocks.size(), false);
    context.fixed.assign(scene.blocks.size(), false);
    const RockNames names(scene);
    for (std::size_t i = 0; i < scene.blocks.size(); ++i)
        if (scene.blocks[i].faces.empty()) checkBlock(scene.blocks[i], i, names, context);
        else
            context.sound[i] = true;
    checkOverlaps(context);
    for (std::size_t i = 0; i < scene.supports.size(); ++i)
        checkSupport(scene.supports[i], under("/supports", i), context);
    checkInSituStress(context);
}

}  // namespace keyblock
