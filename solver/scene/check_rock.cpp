// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks must be blocks before anything can be looked up in them: outlines are
// judged one by one, then pairs for overlap, then what holds them.
#include "geometry/grid.h"
#include "geometry/polygon.h"
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

std::string blockPointer(std::size_t block) { return under("/blocks", block); }

bool hasUsableCorners(const Block& block) {
    return std::all_of(block.points.begin(), block.points.end(), isUsable);  // else the table's ranges have said so
}

// Index of a corner that repeats the one before it (the first: the last); −1 when none does.
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

bool checkRepeatedCorner(const std::vector<Point>& points, const std::string& pointer, const CheckContext& context) {
    const int corner = repeatedCorner(points, context.tolerance);
    if (corner < 0)
        return true;
    if (corner == 0)
        context.report.error(under(pointer, points.size() - 1), "the last corner repeats the first",
                             "Leave it out: outlines close by themselves");
    else
        context.report.error(under(pointer, static_cast<std::size_t>(corner)), "the corner repeats the one before it",
                             "Leave it out");
    return false;
}

bool checkOutline(const Block& block, std::size_t index, CheckContext& context) {
    const std::vector<Point>& points = block.points;
    const std::string pointer = under(blockPointer(index), "points");
    if (!hasUsableCorners(block))
        return false;
    if (points.size() < 3) {
        context.report.error(pointer, "the block has " + std::to_string(points.size()) + " corners",
                             "Give at least three");
        return false;
    }
    if (!checkRepeatedCorner(points, pointer, context))
        return false;
    if (lieOnOneLine(points, context.tolerance)) {
        context.report.error(pointer, "the block has no area", "Give corners that do not lie on one line");
        return false;
    }
    if (const auto place = crossesItself(points, context.tolerance)) {
        context.report.error(pointer,
                             "the outline crosses itself or runs back along itself at (" + shortest(place->x()) +
                                 ", " + shortest(place->y()) + ")",
                             "Give the corners in order round the block, or split it in two");
        return false;
    }
    return true;
}

void checkOverlaps(CheckContext& context) {
    std::vector<std::size_t> blocks;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < context.scene.blocks.size(); ++i) {
        if (!context.sound[i])
            continue;
        blocks.push_back(i);
        boxes.push_back(boxOf(context.scene.blocks[i].points));
    }
    if (boxes.empty())
        return;
    for (const auto& [first, second] : BoxGrid(boxes).meetingPairs()) {
        const std::size_t a = blocks[static_cast<std::size_t>(first)];
        const std::size_t b = blocks[static_cast<std::size_t>(second)];
        if (overlap(context.scene.blocks[a].points, context.scene.blocks[b].points, context.tolerance))
            context.report.error(blockPointer(b),
                                 "the block " + inQuotes(displayName(context.scene, static_cast<int>(b))) +
                                     " overlaps " + inQuotes(displayName(context.scene, static_cast<int>(a))),
                                 "Move corners until the two at most touch");
    }
}

template <typename Named>
std::vector<std::string_view> namesOf(const std::vector<std::pair<std::string, Named>>& items) {
    std::vector<std::string_view> names;
    for (const auto& item : items)
        names.push_back(item.first);
    return names;
}

template <typename Named>
void checkReference(const std::string& name, const std::vector<std::pair<std::string, Named>>& items,
                    std::string_view list, std::string pointer, CheckReport& report) {
    const std::vector<std::string_view> names = namesOf(items);
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
        report.error(std::move(pointer), inQuotes(name) + " is not among the " + inQuotes(list),
                     suggestion(name, names));
}

void checkBlock(const Block& block, std::size_t index, CheckContext& context) {
    const std::string pointer = blockPointer(index);
    checkReference(block.material, context.scene.materials, "materials", under(pointer, "material"), context.report);
    if (block.jointMaterial && block.jointMaterial->empty())
        context.report.error(under(pointer, "joint_material"), "the name is empty", "Give a name, or leave it out");
    if (block.jointMaterial)
        checkReference(*block.jointMaterial, context.scene.jointMaterials, "joint_materials",
                       under(pointer, "joint_material"), context.report);
    context.sound[index] = checkOutline(block, index, context);
}

void checkJointMaterial(const JointMaterial& joint, const std::string& pointer, CheckReport& report) {
    if (joint.residualFrictionAngle && *joint.residualFrictionAngle > joint.frictionAngle)
        report.error(under(pointer, "residual_friction_angle"),
                     "friction cannot grow from " + shortest(joint.frictionAngle) + "° to " +
                         shortest(*joint.residualFrictionAngle) + "° by slip",
                     "Give at most the friction angle, or leave it out");
}

void checkBlockSupport(const Support& support, const std::string& pointer, CheckContext& context) {
    if (support.fix != Fix::All)
        context.report.error(under(pointer, "fix"), "a whole block is held in all its unknowns",
                             "Write \"fix\": \"all\", or give \"point\" instead of \"block_at\"");
    const int block = checkBlockAt(context, *support.blockAt, under(pointer, "block_at"));
    if (block >= 0)
        context.fixed[static_cast<std::size_t>(block)] = true;
}

void checkSupport(const Support& support, const std::string& pointer, CheckContext& context) {
    if (support.blockAt.has_value() == support.point.has_value()) {
        context.report.error(pointer, "a support needs either 'block_at' or 'point'",
                             support.point ? "Leave one of them out" : "Give one of them");
        return;
    }
    if (support.blockAt)
        return checkBlockSupport(support, pointer, context);
    if (support.fix == Fix::All)
        context.report.error(under(pointer, "fix"), "a point is held in x, y or both",
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

}  // namespace

void checkRock(CheckContext& context) {
    const Scene& scene = context.scene;
    checkKeysDiffer(scene.materials, "/materials", "material", context.report);
    checkKeysDiffer(scene.jointMaterials, "/joint_materials", "joint material", context.report);
    for (const auto& [name, joint] : scene.jointMaterials)
        checkJointMaterial(joint, under("/joint_materials", name), context.report);
    checkNamesDiffer(
        scene.blocks.size(), [&](std::size_t i) { return displayName(scene, static_cast<int>(i)); },
        [](std::size_t i) { return under(blockPointer(i), "name"); }, "block", context.report);
    context.sound.assign(scene.blocks.size(), false);
    context.fixed.assign(scene.blocks.size(), false);
    for (std::size_t i = 0; i < scene.blocks.size(); ++i)
        checkBlock(scene.blocks[i], i, context);
    checkOverlaps(context);
    for (std::size_t i = 0; i < scene.supports.size(); ++i)
        checkSupport(scene.supports[i], under("/supports", i), context);
}

}  // namespace keyblock
