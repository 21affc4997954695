// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that every motion, load and velocity of a stage acts on a block, that
// no block has two motions, and that time increases.
#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "geometry/cells/sub_blocks.h"
#include "solver/scene/check_report.h"
#include "solver/scene/collapse_stage.h"
#include "solver/scene/deciding.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"
#include "solver/scene/enum_names.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace keyblock {

namespace {

/// The list entry that was the first to refer to each block.
using Taken = std::map<std::pair<int, int>, std::size_t>;  // key: block and cell

void checkTable(const Table& table, StageKind kind, const std::string& pointer, CheckReport& report) {
    if (!isFinite(table))
        return;  // already reported by the field check
    for (std::size_t i = 1; i < table.size(); ++i)
        if (!(table[i].first > table[i - 1].first))
            report.error(under(pointer, i), "the time " + shortest(table[i].first) + " does not increase",
                         "Sort the rows by time and give each time only once");
    if (!table.empty() && table.front().first < 0.0)
        report.error(under(pointer, 0), "the time is negative", "Count from the start of the stage");
    if (kind == StageKind::Static && !table.empty() && table.back().first > 1.0)
        report.warning(under(pointer, table.size() - 1), "a static stage ends at pseudo-time 1, before this row",
                       "Give times from 0 to 1");
}

void checkNotFixed(int block, const std::string& pointer, std::string_view what, CheckContext& context) {
    if (block >= 0 && context.fixed[block])
        context.report.error(pointer,
                             std::string(what) + " acts on the block " + inQuotes(displayName(context.scene, block)) +
                                 ", which is fixed by a support",
                             "Remove one of the two");
}

/// Cell at `place` in a block that is divided into cells; 0 for other blocks.
int cellAt(int block, const Point& place, const CheckContext& context) {
    if (block < 0 || !context.sound[block])
        return 0;
    const Block& own = context.scene.blocks[block];
    if (!own.subBlocks || !(own.subBlocks->size > 0.0) || gridCells(own.points, own.subBlocks->size) > mostCells)
        return 0;
    const SubBlocks cut = cutIntoCells(own.points, own.subBlocks->size, context.tolerance);
    const auto holds = [&](const auto& cell) { return locate(cell, place, context.tolerance) != Side::Outside; };
    return static_cast<int>(std::find_if(cut.cells.begin(), cut.cells.end(), holds) - cut.cells.begin());
}

void checkTakenOnce(int block, int cell, std::size_t entry, const std::string& pointer, std::string_view what,
                    Taken& taken, CheckContext& context) {
    if (block < 0)
        return;
    const auto [first, isNew] = taken.try_emplace({block, cell}, entry);
    if (!isNew)
        context.report.error(pointer,
                             "the block " + inQuotes(displayName(context.scene, block)) + " already has a " +
                                 std::string(what) + " in this stage (entry " + std::to_string(first->second) + ")",
                             "Give a block only one " + std::string(what) +
                                 " per stage; an inclined axis can be given as a vector");
}

void checkMotion(const Motion& motion, std::size_t entry, std::size_t stage, const std::string& pointer, Taken& taken,
                 CheckContext& context) {
    const int block = checkBlockAt(context, motion.blockAt, under(pointer, "block_at"));
    checkNotFixed(block, under(pointer, "block_at"), "the motion", context);
    checkStands(block, stage, under(pointer, "block_at"), context);
    const int cell = cellAt(block, motion.blockAt, context);
    checkTakenOnce(block, cell, entry, under(pointer, "block_at"), "motion", taken, context);
    checkAxis(motion.axis, under(pointer, "axis"), context.report);
    if (motion.table.empty())
        context.report.error(under(pointer, "table"), "the motion has no table",
                             "Give rows of time and displacement [m]");
    checkTable(motion.table, context.scene.stages[stage].kind, under(pointer, "table"), context.report);
}

bool liesAlong(const Point& from, const Point& to, const std::array<Point, 2>& line, double tolerance) {
    const Point direction = (line[1] - line[0]).normalized();
    const auto off = [&](const Point& p) { return std::abs(cross(direction, p - line[0])); };
    if (off(from) > tolerance || off(to) > tolerance)
        return false;
    const double a = direction.dot(from - line[0]);
    const double b = direction.dot(to - line[0]);
    const double length = (line[1] - line[0]).norm();
    return std::min(std::max(a, b), length) - std::max(std::min(a, b), 0.0) > tolerance;
}

bool someEdgeLiesAlong(const std::array<Point, 2>& line, const CheckContext& context) {
    for (const Block& block : context.scene.blocks)
        for (std::size_t i = 0; i < block.points.size(); ++i)
            if (liesAlong(block.points[i], block.points[(i + 1) % block.points.size()], line, context.tolerance))
                return true;
    return false;
}

void checkPressure(const Load& load, const std::string& pointer, CheckContext& context) {
    const std::array<Point, 2>& line = *load.along;
    if (load.force != Point(0.0, 0.0))
        context.report.error(under(pointer, "force"), "a load along a line is a pressure, not a force",
                             "Give 'pressure' [Pa], or 'point' or 'block_at' with the force");
    if (load.pressure == 0.0)
        context.report.warning(pointer, "the pressure is 0", "Give 'pressure' [Pa], or omit the load");
    if (!line[0].allFinite() || !line[1].allFinite())
        return;
    if ((line[1] - line[0]).norm() <= context.tolerance)
        context.report.error(under(pointer, "along"), "the line has no length", "Give two different points");
    else if (context.allSound() && !someEdgeLiesAlong(line, context))
        context.report.error(under(pointer, "along"), "no edge of a block lies along the line",
                             "Give the two ends of an edge or of a row of edges");
}

void checkPlaceOfForce(const Load& load, int block, const std::string& pointer, CheckContext& context) {
    if (!load.at || block < 0 || !load.at->allFinite())
        return;
    const std::vector<Point>& points = context.scene.blocks[block].points;
    if (locate(points, *load.at, context.tolerance) == Side::Outside)
        context.report.error(under(pointer, "at"),
                             "the force acts outside the block " + inQuotes(displayName(context.scene, block)),
                             "Give a point of that block");
}

void checkForce(const Load& load, std::size_t stage, const std::string& pointer, CheckContext& context) {
    if (load.force == Point(0.0, 0.0))
        context.report.warning(pointer, "the force is 0", "Give 'force' [N], or omit the load");
    const std::string place = under(pointer, load.blockAt ? "block_at" : "point");
    const int block = load.blockAt ? checkBlockAt(context, *load.blockAt, place)
                                   : checkPointOnBlock(context, *load.point, place);
    if (load.blockAt)
        checkNotFixed(block, place, "the load", context);
    checkStands(block, stage, place, context);
    checkPlaceOfForce(load, block, pointer, context);
}

void checkLoad(const Load& load, std::size_t stage, const std::string& pointer, CheckContext& context) {
    const int places = (load.blockAt ? 1 : 0) + (load.point ? 1 : 0) + (load.along ? 1 : 0);
    if (places != 1)
        context.report.error(pointer, "a load needs exactly one of 'block_at', 'point' and 'along'",
                             places == 0 ? "Give one of them" : "Keep only one of them");
    else if (load.along)
        checkPressure(load, pointer, context);
    else
        checkForce(load, stage, pointer, context);
    checkTable(load.table, context.scene.stages[stage].kind, under(pointer, "table"), context.report);
}

void checkVelocity(const InitialVelocity& velocity, std::size_t entry, std::size_t stage, const std::string& pointer,
                   Taken& taken, CheckContext& context) {
    const int block = checkBlockAt(context, velocity.blockAt, under(pointer, "block_at"));
    checkNotFixed(block, under(pointer, "block_at"), "the velocity", context);
    checkStands(block, stage, under(pointer, "block_at"), context);
    checkTakenOnce(block, 0, entry, under(pointer, "block_at"), "velocity", taken, context);
}

void checkTimes(const Stage& stage, const std::string& pointer, CheckReport& report) {
    if (stage.kind == StageKind::Static)
        return;
    constexpr double leastDuration = 1e-20;  // [s]; no time step fits into less
    if (stage.duration >= 0.0 && stage.duration < leastDuration)
        report.error(under(pointer, "duration"), "a dynamic stage needs a duration", "Give a duration in seconds, above 0");
    else if (stage.timeStep && *stage.timeStep > stage.duration)
        report.warning(under(pointer, "time_step"), "the time step is longer than the stage",
                       "Give a shorter time step, or omit it to let the program choose",
                       {RepairKind::SetAutomatic, under(pointer, "time_step")});
}

void checkScheme(const Stage& stage, const std::string& pointer, CheckContext& context) {
    const Integration integration = stage.integration.value_or(context.scene.analysis.integration);
    if (stage.rhoInf && integration != Integration::GeneralizedAlpha)
        context.report.warning(under(pointer, "rho_inf"), "only the scheme 'generalized-alpha' uses rho_inf",
                               "Give \"integration\": \"generalized-alpha\", or omit it");
    const bool endForces = integration == Integration::Shi || integration == Integration::BackwardEuler;
    const bool classical = context.scene.analysis.iteration == Iteration::OpenClose;
    if (stage.kind == StageKind::Dynamic && classical && !endForces)
        context.report.error(stage.integration ? under(pointer, "integration") : "/analysis/integration",
                             "the open–close iteration handles only forces at the end of a step",
                             "Use the integration \"shi\" or \"backward-euler\", or the iteration \"convex\"");
}

// True if any face of a cut block satisfies the predicate.
template <typename Question>
bool someFace(const CheckContext& context, const Question& question) {
    return std::any_of(context.scene.blocks.begin(), context.scene.blocks.end(), [&](const Block& block) {
        return std::any_of(block.faces.begin(), block.faces.end(), question);
    });
}

void checkDilated(const std::string& joint, const std::string& pointer, CheckContext& context) {
    std::vector<std::string_view> names = namesOf(context.document.joints);
    for (const auto& more : {namesOf(context.document.jointSets), namesOf(context.document.jointMaterials)})
        names.insert(names.end(), more.begin(), more.end());
    std::erase(names, std::string_view());
    if (joint.empty() || context.report.isFull()) return;  // already reported by the field check
    if (std::find(names.begin(), names.end(), joint) == names.end())
        return context.report.error(pointer, "there is no joint, joint set or joint material " + inQuotes(joint),
                                    suggestion(joint, names));
    const int source = traceSource(context.document, joint);
    if (source >= 0 && context.isCut && !someFace(context, [&](const CutFace& face) { return face.source == source; }))
        context.report.warning(pointer, "no face of a block lies on " + inQuotes(joint) + ", so nothing opens",
                               "See the notes on the cut, or omit it");
}

void checkDilations(const Stage& stage, const std::string& pointer, CheckContext& context) {
    for (std::size_t i = 0; i < stage.dilations.size(); ++i) {
        const std::string& joint = stage.dilations[i].joint;
        const std::string at = under(under(under(pointer, "dilations"), i), "joint");
        checkDilated(joint, at, context);
        for (std::size_t before = 0; before < i; ++before)
            if (stage.dilations[before].joint == joint)
                context.report.error(at, "the joint " + inQuotes(joint) + " already opens in this stage",
                                     "Give only one rate");
    }
}

void checkSides(const Stage& stage, const std::string& pointer, CheckContext& context) {
    const std::vector<std::string_view> words(boundarySideWords.begin(), boundarySideWords.end());
    for (std::size_t i = 0; i < stage.viscousBoundaries.size(); ++i) {
        const std::string& name = stage.viscousBoundaries[i];
        const std::string at = under(under(pointer, "viscous_boundaries"), i);
        const auto word = std::find(words.begin(), words.end(), name);
        const auto side = static_cast<BoundarySide>(word - words.begin());
        if (word == words.end())
            context.report.error(at, "there is no side " + inQuotes(name), suggestion(name, words));
        else if (context.document.domain && context.isCut &&
                 !someFace(context, [&](const CutFace& face) { return isOnSide(face, side); }))
            context.report.error(at, "no block has a face on that side of the domain",
                                 "Give another side: an edge belongs to the side that its outward normal points to");
    }
}

/// Median area of the blocks [m²].
double medianArea(const CheckContext& context) {
    std::vector<double> areas;
    for (const Block& block : context.scene.blocks) areas.push_back(std::abs(signedArea(block.points)));
    const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
    std::nth_element(areas.begin(), middle, areas.end());
    return *middle;
}

/// Blocks that are ignored in the verdict must be small compared with the other blocks.
void checkSmallest(const Stage& stage, const std::string& pointer, CheckContext& context) {
    constexpr double most = 0.05;  // ratio to the median block area
    if (stage.kind != StageKind::Static || context.scene.blocks.empty()) return;
    const double smallest = smallestOf(stage), median = medianArea(context);
    if (!(smallest > most * median)) return;
    context.report.warning(under(under(pointer, "until"), "smallest"),
                           "blocks under " + rounded(smallest) + " m² do not decide whether the stage is stable, but "
                           "half of all blocks are smaller than " + rounded(median) + " m²",
                           "Give less than a twentieth of that area, or 0 so that all blocks decide");
}

/// The motion after a collapse has its own name in tables, which no stage may have.
void checkCollapseNames(const std::vector<Stage>& stages, CheckReport& report) {
    for (const Stage& stage : stages) {
        if (stage.kind != StageKind::Static || stage.onCollapse == OnCollapse::End) continue;
        const std::string taken = nameOfCollapse(stage);
        for (std::size_t i = 0; i < stages.size(); ++i)
            if (stages[i].name == taken)
                report.error(under(under("/stages", i), "name"),
                             "the motion after a collapse of stage " + inQuotes(stage.name) + " is called " + inQuotes(taken) +
                                 " as well",
                             "Give this stage another name");
    }
}

void checkStage(std::size_t index, const std::string& pointer, CheckContext& context) {
    const Stage& stage = context.scene.stages[index];
    checkTimes(stage, pointer, context.report);
    checkSmallest(stage, pointer, context);
    checkStrengthChanges(stage, pointer, context);
    checkAccelerations(stage, pointer, context);
    checkScheme(stage, pointer, context);
    checkDilations(stage, pointer, context);
    checkSides(stage, pointer, context);
    Taken moved;
    for (std::size_t i = 0; i < stage.motions.size(); ++i)
        checkMotion(stage.motions[i], i, index, under(under(pointer, "motions"), i), moved, context);
    for (std::size_t i = 0; i < stage.loads.size(); ++i)
        checkLoad(stage.loads[i], index, under(under(pointer, "loads"), i), context);
    Taken thrown;
    for (std::size_t i = 0; i < stage.initialVelocities.size(); ++i)
        checkVelocity(stage.initialVelocities[i], i, index, under(under(pointer, "initial_velocities"), i), thrown,
                      context);
}

}  // namespace

void checkStages(CheckContext& context) {
    const std::vector<Stage>& stages = context.scene.stages;
    const bool needsBlocks = !stages.empty() || !context.scene.bolts.empty() || !context.scene.supports.empty();
    if (context.scene.blocks.empty() && context.isCut && needsBlocks)
        context.report.error("/blocks", "the scene has no blocks",
                             context.document.domain ? "Leave some rock of the domain outside the open tunnels"
                                                     : "Give at least one, or a domain to cut");
    if (stages.empty())
        context.report.warning("", "the scene has no stages, so there is nothing to run",
                               "Add 'stages', or use the scene for checks only", {RepairKind::AddStage, "/stages"});
    checkNamesDiffer(
        stages.size(), [&](std::size_t i) { return stages[i].name; },
        [](std::size_t i) { return under(under("/stages", i), "name"); }, "stage", context.report);
    checkCollapseNames(stages, context.report);
    for (std::size_t i = 0; i < stages.size(); ++i)
        checkStage(i, under("/stages", i), context);
    checkActivation(context);
    checkLengthOfRecords(context);
}

}  // namespace keyblock
