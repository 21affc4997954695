// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that bolts have a length, run through rock and have their anchors
// within their length.
#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <limits>

namespace keyblock {

namespace {

/// Pointer to a field of the bolt. Bolts of a pattern lack these fields, so errors are reported at the pattern.
std::string placeIn(const Bolt& bolt, const std::string& pointer, std::string_view key) {
    return bolt.pattern < 0 ? under(pointer, key) : pointer;
}

/// The bolt as messages refer to it; a bolt of a pattern is named.
std::string nameOf(const Bolt& bolt) { return bolt.pattern < 0 ? "the bolt" : "the bolt " + inQuotes(bolt.name); }

constexpr int usualDivisions = 60;  // if the bolt does not give its divisions; used to judge the gap at its head

/// Part of a bolt that lies along an edge of a block; distances from the far end [m].
struct AlongFace {
    int block = -1;
    double from = 0.0, to = 0.0;
};

/// The part nearest to the far end that lies along a face and is longer than the tolerance; `block` is −1 if there is
/// none.
AlongFace alongFace(const Bolt& bolt, const CheckContext& context) {
    const double length = lengthOf(bolt);
    const Point axis = (bolt.head - bolt.farEnd) / length;
    AlongFace found;
    for (std::size_t i = 0; i < context.scene.blocks.size(); ++i) {
        const std::vector<Point>& points = context.scene.blocks[i].points;
        for (std::size_t e = 0; context.sound[i] && e < points.size(); ++e) {
            const Point p = points[e] - bolt.farEnd, q = points[(e + 1) % points.size()] - bolt.farEnd;
            if (std::max(std::abs(cross(axis, p)), std::abs(cross(axis, q))) > context.tolerance) continue;
            const double from = std::max(0.0, std::min(axis.dot(p), axis.dot(q)));
            const double to = std::min(length, std::max(axis.dot(p), axis.dot(q)));
            if (to - from <= 2.0 * context.tolerance || (found.block >= 0 && found.from <= from)) continue;
            found = {static_cast<int>(i), from, to};
        }
    }
    return found;
}

/// Reports a bolt that lies along a face and returns false for it.
bool checkAlongFaces(const Bolt& bolt, const std::string& pointer, CheckContext& context) {
    const AlongFace along = alongFace(bolt, context);
    if (along.block < 0)
        return true;
    context.report.error(pointer,
                         nameOf(bolt) + " lies along a face of the block " +
                             inQuotes(displayName(context.scene, along.block)) + " from " + rounded(along.from) +
                             " m to " + rounded(along.to) + " m of its length, so the rock that supports it is not defined",
                         "Move or turn it by more than " + rounded(2.0 * context.tolerance) +
                             " m, into the rock on one side");
    return false;
}

double distanceToRock(const Point& place, const CheckContext& context) {
    if (blockWithPoint(context.scene, place) >= 0)
        return 0.0;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < context.scene.blocks.size(); ++i)
        if (context.sound[i])
            distance = std::min(distance, distanceToBoundary(context.scene.blocks[i].points, place));
    return distance;
}

bool headHangs(const Bolt& bolt, const CheckContext& context) {
    const double division = lengthOf(bolt) / bolt.divisions.value_or(usualDivisions);
    return bolt.plate == PlateKind::Spring && context.allSound() && distanceToRock(bolt.head, context) > division;
}

void checkHead(const Bolt& bolt, const std::string& pointer, CheckContext& context) {
    if (headHangs(bolt, context))
        context.report.warning(placeIn(bolt, pointer, "head"),
                               "the head of " + nameOf(bolt) + " is not on rock, so its plate has no effect",
                               "Put the head on the wall, or write \"plate\": \"none\"",
                               {RepairKind::RemovePlate, under(pointer, "plate")});
}

// Returns true if the bolt is long enough for the other checks.
bool checkPosition(const Bolt& bolt, const std::string& pointer, CheckContext& context) {
    if (!bolt.farEnd.allFinite() || !bolt.head.allFinite())
        return false;
    if (lengthOf(bolt) <= context.tolerance) {
        context.report.error(placeIn(bolt, pointer, "head"),
                             "the head coincides with the far end, so the bolt has no length",
                             "Give two different points");
        return false;
    }
    if (!checkAlongFaces(bolt, pointer, context))
        return true;
    if (runsThroughRock(bolt, context, {}))
        checkHead(bolt, pointer, context);
    else if (context.allSound())
        context.report.error(pointer, nameOf(bolt) + " does not run through any block", "Move it into the rock");
    return true;
}

// Returns false if the position is beyond the end of the bolt.
bool checkPlaceOnBolt(const BoltPlace& place, double length, double tolerance, const std::string& pointer,
                      std::string_view what, CheckReport& report) {
    if (distanceAlong(place, length) <= length + tolerance)
        return true;
    report.error(pointer,
                 std::string(what) + " at " + shortest(place.s) + " m lies past the end of the bolt, which is " +
                     rounded(length) + " m long",
                 "Give the distance from the far end, at most the length of the bolt");
    return false;
}

// Errors in a bolt's own anchors are reported at the anchor; errors in the anchors of its type once, at `type`.
void checkAnchorPlaces(const Bolt& bolt, const BoltType* type, const std::string& pointer, CheckContext& context) {
    if (!bolt.anchors && !type)
        return;
    const std::vector<Anchor>& anchors = bolt.anchors ? *bolt.anchors : type->anchors;
    const double length = lengthOf(bolt);
    const double tolerance = std::max(context.tolerance, 1e-9 * length);
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        const Anchor& anchor = anchors[i];
        const auto place = [&](std::string_view key) {
            return bolt.anchors ? under(under(under(pointer, "anchors"), i), key) : under(pointer, "type");
        };
        const bool fits =
            anchor.at ? checkPlaceOnBolt(*anchor.at, length, tolerance, place("at"), "an anchor", context.report)
                      : checkPlaceOnBolt(anchor.to, length, tolerance, place("to"), "the end of an anchor's range",
                                         context.report);
        if (!fits && !bolt.anchors)
            return;
    }
}

std::vector<std::string_view> typeNames(const Scene& scene) {
    std::vector<std::string_view> names;
    for (const BoltType& type : scene.boltTypes)
        names.push_back(type.name);
    return names;
}

const BoltType* checkType(const Bolt& bolt, const std::string& pointer, CheckContext& context) {
    const BoltType* type = findBoltType(context.scene, bolt.type);
    if (!type && !bolt.type.empty() && bolt.pattern < 0 &&
        !context.report.isFull())  // the type of a pattern is reported once, at the pattern
        context.report.error(under(pointer, "type"), "there is no bolt type " + inQuotes(bolt.type),
                             suggestion(bolt.type, typeNames(context.scene)) +
                                 "; built-in types are listed by 'keyblock bolts'");
    return type;
}

// Checks that the pretension can act. The bolt needs a plate on rock, and the first stage must be static, because the
// pretension is locked off at its equilibrium.
void checkPretension(const Bolt& bolt, const std::string& pointer, CheckContext& context) {
    if (!(bolt.pretension > 0.0))
        return;
    const std::string place = under(pointer, "pretension");
    const std::vector<Stage>& stages = context.scene.stages;
    if (bolt.plate == PlateKind::None)
        context.report.error(place, "the bolt has no plate to carry its pretension",
                             "Give it a plate, or omit the pretension");
    else if (headHangs(bolt, context))
        context.report.error(place, "the head of " + nameOf(bolt) + " is not on rock: its plate has no rock to press "
                                    "against",
                             "Put the head on the wall, or omit the pretension");
    else if (!stages.empty() && stages.front().kind == StageKind::Dynamic)
        context.report.error(place, "the pretension is locked off at equilibrium, but the first stage is dynamic",
                             "Put a static stage before it");
}

}  // namespace

bool runsThroughRock(const Bolt& bolt, const CheckContext& context, const std::vector<bool>& gone) {
    const std::vector<Point> ends{bolt.farEnd, bolt.head};
    const Box box = grown(boxOf(ends), context.tolerance);
    for (std::size_t i = 0; i < context.scene.blocks.size(); ++i) {
        const std::vector<Point>& points = context.scene.blocks[i].points;
        if (context.sound[i] && (gone.empty() || !gone[i]) && meets(boxOf(points), box) &&
            !insideIntervals(points, bolt.farEnd, bolt.head, context.tolerance).empty())
            return true;
    }
    return false;
}

void checkBolts(CheckContext& context) {
    const std::vector<Bolt>& bolts = context.scene.bolts;
    checkNamesDiffer(
        bolts.size(), [&](std::size_t i) { return bolts[i].name; },
        [&](std::size_t i) { return under(boltPointer(context.scene, i), "name"); }, "bolt", context.report);
    checkBoltNames(context);
    for (std::size_t i = 0; i < bolts.size(); ++i) {
        const std::string pointer = boltPointer(context.scene, i);
        const BoltType* type = checkType(bolts[i], pointer, context);
        if (bolts[i].anchors)
            checkAnchors(*bolts[i].anchors, under(pointer, "anchors"), context.report);
        if (!checkPosition(bolts[i], pointer, context))
            continue;
        checkAnchorPlaces(bolts[i], type, pointer, context);
        checkPretension(bolts[i], pointer, context);
    }
}

}  // namespace keyblock
