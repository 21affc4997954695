// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that the section can be cut and that its size is plausible: the
// numbers of traces, cells and crossings are estimated before anything is
// generated. The geometry module says what is wrong with a shape; this file
// adds where.
#include "geometry/cells/voronoi.h"
#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/shapes.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {

namespace {

constexpr double mostTraces = 10000.0;  // in a scene; also the limit of Voronoi cells
constexpr double mostCrossings = 200000.0;  // each crossing gives about one block
constexpr double mostBolts = 10000.0;  // in a pattern
constexpr double coarsestTolerance = 0.01;  // ratio to the size of the domain, the same as in the cut

void tell(const std::optional<ShapeProblem>& problem, const std::string& pointer, CheckReport& report) {
    if (!problem || std::any_of(report.problems.begin(), report.problems.end(), [&](const Problem& known) {
            return known.pointer == under(pointer, problem->field);
        }))
        return;  // already reported by the range check of the field
    std::string remedy = problem->remedy;
    if (!remedy.empty())
        remedy.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(remedy.front())));
    report.error(under(pointer, problem->field), problem->message, remedy);
}

void checkJointMaterialOf(const std::optional<std::string>& name, const std::string& pointer, CheckContext& context) {
    if (name && name->empty())
        context.report.error(under(pointer, "joint_material"), "the name is empty", "Give a name, or omit it");
    else if (name)
        checkReference(*name, namesOf(context.scene.jointMaterials), "joint_materials",
                       under(pointer, "joint_material"), context.report);
}

// Outline of the named region, or of the domain if there is no name; null if it cannot be used.
const std::vector<Point>* checkRegionOf(const std::optional<std::string>& name, const std::string& pointer,
                                        CheckContext& context) {
    const Scene& scene = context.scene;
    const SceneRegion* region = name ? findRegion(scene, *name) : nullptr;
    if (name && !region && !context.report.isFull())
        context.report.error(under(pointer, "region"), inQuotes(*name) + " is not among the 'regions'",
                             suggestion(*name, namesOf(scene.regions)));
    const std::vector<Point>* points = region ? &region->points
                                       : !name && scene.domain ? &scene.domain->boundary : nullptr;
    const bool usable = points && points->size() >= 3 && std::all_of(points->begin(), points->end(), isUsable);
    return usable ? points : nullptr;
}

// Reports an error if there is no domain, since there is nothing to cut.
bool checkHasDomain(const std::string& pointer, CheckContext& context) {
    if (context.scene.domain)
        return true;
    context.report.error(pointer, "the scene has no domain to cut", "Give a domain, or omit this");
    return false;
}

bool checkDomain(CheckContext& context) {
    const SceneDomain& domain = *context.scene.domain;
    checkReference(domain.material, namesOf(context.scene.materials), "materials", "/domain/material", context.report);
    checkJointMaterialOf(domain.jointMaterial, "/domain", context);
    if (!checkOutline(domain.boundary, "/domain/boundary", "the domain", context.tolerance, context.report))
        return false;
    const Box box = boxOf(domain.boundary);
    const double size = (box.max - box.min).maxCoeff();
    const std::optional<double>& tolerance = context.scene.cutting.tolerance;
    if (tolerance && *tolerance > coarsestTolerance * size)
        context.report.error("/cutting/tolerance",
                             "a tolerance of " + shortest(*tolerance) + " m is more than a hundredth of the domain",
                             "Give at most " + rounded(coarsestTolerance * size) + " m, or omit it");
    return true;
}

void checkOverlapWithDomain(CheckContext& context) {
    const Scene& scene = context.scene;
    for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
        const std::vector<Point>& points = scene.blocks[i].points;
        const bool sound = points.size() >= 3 && points.size() <= mostCorners &&
                           std::all_of(points.begin(), points.end(), isUsable) &&
                           !crossesItself(points, context.tolerance);
        if (sound && overlap(scene.domain->boundary, points, context.tolerance) &&
            !standsInOpening(scene, points))
            context.report.error(under("/blocks", i),
                                 "the block " + inQuotes(displayName(scene, static_cast<int>(i))) +
                                     " overlaps the domain",
                                 "Move it out of the domain or completely into a tunnel that no stage excavates, or "
                                 "outline it there with joints");
    }
}

void checkJoint(const SceneJoint& joint, const std::string& pointer, CheckContext& context) {
    checkJointMaterialOf(joint.jointMaterial, pointer, context);
    if (!checkHasDomain(pointer, context))
        return;
    if (joint.points.size() < 2)
        context.report.error(under(pointer, "points"),
                             "the joint has " + std::to_string(joint.points.size()) + " points", "Give two or more");
}

// Estimated number of traces; 0 if there are other errors.
double checkJointSet(const SceneJointSet& set, const std::string& pointer, CheckContext& context) {
    checkJointMaterialOf(set.jointMaterial, pointer, context);
    const std::vector<Point>* region = checkRegionOf(set.region, pointer, context);
    if (!checkHasDomain(pointer, context))
        return 0.0;
    const JointSet drawn = jointSetOf(set);
    const std::optional<ShapeProblem> problem = jointSetProblem(drawn);
    tell(problem, pointer, context.report);
    if (problem || !region || !isUsable(set.origin))
        return 0.0;
    const double traces = jointTraceEstimate(drawn, *region);
    if (traces <= mostTraces)
        return traces;
    context.report.error(under(pointer, "spacing"),
                         "the joint set would produce about " + shortest(std::round(traces)) + " traces; the limit is " +
                             shortest(mostTraces),
                         "Give a larger spacing or trace length, or a smaller region");
    return 0.0;
}

double checkVoronoi(CheckContext& context) {
    const SceneVoronoi& voronoi = *context.scene.voronoi;
    checkJointMaterialOf(voronoi.jointMaterial, "/voronoi", context);
    const std::vector<Point>* region = checkRegionOf(voronoi.region, "/voronoi", context);
    if (!checkHasDomain("/voronoi", context) || !region || !(voronoi.size > 0.0) || !std::isfinite(voronoi.size))
        return 0.0;
    const double cells = voronoiEstimate(*region, voronoi.size);
    if (cells <= mostTraces)
        return cells;  // each cell adds about three traces, which meet only at their ends
    context.report.error("/voronoi/size",
                         "cells of " + shortest(voronoi.size) + " m are about " + shortest(std::round(cells)) +
                             "; the limit is " + shortest(mostTraces),
                         "Give a larger size, or a smaller region");
    return 0.0;
}

void checkTunnel(const SceneTunnel& tunnel, const std::string& pointer, CheckContext& context) {
    if (tunnel.profile == ProfileKind::Polygon) {
        const bool sound = checkOutline(tunnel.points, under(pointer, "points"), "the tunnel", context.tolerance,
                                        context.report);
        if (!sound)
            return;
    }
    if (isUsable(tunnel.center))
        tell(profileProblem(shapeOf(tunnel)), pointer, context.report);
}

void checkPattern(const ScenePattern& pattern, const std::string& pointer, CheckContext& context) {
    const Scene& scene = context.scene;
    if (!pattern.type.empty() && !findBoltType(scene, pattern.type) && !context.report.isFull())
        context.report.error(under(pointer, "type"), "there is no bolt type " + inQuotes(pattern.type),
                             suggestion(pattern.type, namesOf(scene.boltTypes)) +
                                 "; built-in types are listed by 'keyblock bolts'");
    checkReference(pattern.tunnel, namesOf(scene.tunnels), "tunnels", under(pointer, "tunnel"), context.report);
    const std::optional<ShapeProblem> problem = boltPatternProblem(patternOf(pattern));
    tell(problem, pointer, context.report);
    const int tunnel = findTunnel(scene, pattern.tunnel);
    if (problem || tunnel < 0)
        return;
    const ProfileShape shape = shapeOf(scene.tunnels[tunnel]);
    if (profileProblem(shape))
        return;
    const double bolts = boltCount(tunnelProfile(shape), patternOf(pattern));
    if (bolts > mostBolts)
        context.report.error(under(pointer, "spacing"),
                             "the pattern would have " + shortest(bolts) + " bolts; the limit is " +
                                 shortest(mostBolts),
                             "Give a larger spacing");
    else if (bolts < 1.0)
        context.report.warning(pointer, "the pattern has no bolts: its offset lies beyond its end",
                               "Give a smaller offset");
}

/// Names that stages refer to must be unique across both lists.
void checkNameIsFree(const std::string& name, const std::string& pointer, const std::vector<std::string_view>& others,
                     const std::string& list, const std::string& what, CheckContext& context) {
    const auto found = std::find(others.begin(), others.end(), name);
    if (!name.empty() && found != others.end())
        context.report.error(pointer,
                             "the name " + inQuotes(name) + " is already used by a " + what + " (" +
                                 under(list, static_cast<std::size_t>(found - others.begin())) + ")",
                             "Give it another name: stages refer to both by name");
}

void checkNames(CheckContext& context) {
    const Scene& scene = context.scene;
    const auto differ = [&](const auto& items, const std::string& list, std::string_view what) {
        checkNamesDiffer(
            items.size(), [&](std::size_t i) { return items[i].name; },
            [&](std::size_t i) { return under(under(list, i), "name"); }, what, context.report);
    };
    differ(scene.joints, "/joints", "joint");
    differ(scene.jointSets, "/joint_sets", "joint set");
    differ(scene.regions, "/regions", "region");
    differ(scene.tunnels, "/tunnels", "tunnel");
    differ(scene.boltPatterns, "/bolt_patterns", "bolt pattern");
    for (std::size_t i = 0; i < scene.blocks.size(); ++i)
        checkNameIsFree(scene.blocks[i].name, under(under("/blocks", i), "name"), namesOf(scene.tunnels), "/tunnels",
                        "tunnel", context);
}

double leftOf(const CutTrace& trace) { return std::min(trace.from.x(), trace.to.x()); }

/// Number of pairs of traces that cross; stops counting above the limit.
double crossingsOf(std::vector<CutTrace> traces) {
    std::sort(traces.begin(), traces.end(), [](const CutTrace& a, const CutTrace& b) { return leftOf(a) < leftOf(b); });
    double count = 0.0;
    for (std::size_t i = 0; i < traces.size() && count <= mostCrossings; ++i) {
        const Box box = boxOf(std::vector<Point>{traces[i].from, traces[i].to});
        for (std::size_t j = i + 1; j < traces.size() && leftOf(traces[j]) <= box.max.x(); ++j) {
            if (std::max(traces[j].from.y(), traces[j].to.y()) < box.min.y() ||
                std::min(traces[j].from.y(), traces[j].to.y()) > box.max.y())
                continue;
            if (crossing(traces[i].from, traces[i].to, traces[j].from, traces[j].to))
                count += 1.0;
        }
    }
    return count;
}

// The lists together may exceed a limit that each one meets on its own.
void checkAmount(double traces, CheckContext& context) {
    const auto refuse = [&](const std::string& what, double most) {
        context.report.error("/domain", what + " are too many: the limit is " + shortest(most),
                             "Give larger spacings or fewer joint sets, or confine them to a smaller region");
    };
    if (traces > mostTraces)
        return refuse("about " + shortest(std::round(traces)) + " traces of all joints in total", mostTraces);
    if (hasErrors(context.report.problems))
        return;
    if (crossingsOf(tracesOf(context.scene).traces) > mostCrossings)
        refuse("the crossings of its joints", mostCrossings);
}

}  // namespace

void checkBoltNames(CheckContext& context) {
    const Scene& scene = context.scene;
    for (std::size_t i = 0; i < scene.bolts.size(); ++i)
        checkNameIsFree(scene.bolts[i].name, under(boltPointer(scene, i), "name"), namesOf(scene.boltPatterns),
                        "/bolt_patterns", "bolt pattern", context);
}

void checkSection(CheckContext& context) {
    assert(&context.scene == &context.document);
    const Scene& scene = context.scene;
    checkNames(context);
    bool sound = scene.domain && checkDomain(context);
    if (sound)
        checkOverlapWithDomain(context);
    for (std::size_t i = 0; i < scene.regions.size(); ++i)
        checkOutline(scene.regions[i].points, under(under("/regions", i), "points"), "the region", context.tolerance,
                     context.report);
    double traces = 0.0;
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        checkJoint(scene.joints[i], under("/joints", i), context);
        traces += static_cast<double>(scene.joints[i].points.size());
    }
    for (std::size_t i = 0; i < scene.jointSets.size(); ++i)
        traces += checkJointSet(scene.jointSets[i], under("/joint_sets", i), context);
    if (scene.voronoi)
        traces += checkVoronoi(context);
    for (std::size_t i = 0; i < scene.tunnels.size(); ++i)
        checkTunnel(scene.tunnels[i], under("/tunnels", i), context);
    for (std::size_t i = 0; i < scene.boltPatterns.size(); ++i)
        checkPattern(scene.boltPatterns[i], under("/bolt_patterns", i), context);
    if (sound)
        checkAmount(traces, context);
}

}  // namespace keyblock
