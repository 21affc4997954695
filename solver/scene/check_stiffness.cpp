// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Warns of loads that are too large for the stiffness of rock and contacts, and of
// motion that is too fast for them or for the time step. The method assumes small
// strains, and contacts whose penetration is small compared with the blocks; beyond
// that, its results would be wrong without a sign of it.
#include "geometry/polygon.h"
#include "solver/scene/automatic.h"
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/preset.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

constexpr double mostStrain = 0.01;
constexpr double mostPenetration = 0.01;  // of the size of a block
constexpr double mostOfSmallest = 0.05;  // the same, of the smallest block under the weight of the largest
constexpr double mostFall = 0.05;  // fall from rest in one time step / size of the smallest block
constexpr double mostTurn = 0.3;  // [rad] in one time step
constexpr double leastStrain = 1e-13;  // below it, displacements are lost in the digits of the coordinates

/// What matters of a checked scene's blocks.
struct RockExtent {
    double weakest = std::numeric_limits<double>::infinity();  // least Young's modulus of all blocks [Pa]
    std::string weakestName;
    double soft = std::numeric_limits<double>::infinity();  // least Young's modulus of blocks that are not fixed [Pa]
    std::string softName;
    double heaviest = 0.0;  // largest weight of a block that is not fixed, per metre of thickness [N/m]
    double overburden = 0.0;  // stress under the weight of all such rock [Pa]
    double smallest = std::numeric_limits<double>::infinity();  // size of the smallest such block [m]
    bool any = false;
};

double sizeOf(const Block& block) { return std::sqrt(std::abs(signedArea(block.points))); }

RockExtent extentOf(const CheckContext& context) {
    const Scene& scene = context.scene;
    const double gravity = scene.analysis.gravity.norm();
    const Point down = gravity > 0.0 ? Point(scene.analysis.gravity / gravity) : Point(0.0, -1.0);
    RockExtent extent;
    double top = std::numeric_limits<double>::infinity(), bottom = -top, density = 0.0;
    for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
        const Block& block = scene.blocks[i];
        const Material& material = materialOf(scene, block);
        if (material.youngsModulus < extent.weakest) {
            extent.weakest = material.youngsModulus;
            extent.weakestName = block.material;
        }
        if (context.fixed[i]) continue;
        extent.any = true;
        if (material.youngsModulus < extent.soft) {
            extent.soft = material.youngsModulus;
            extent.softName = block.material;
        }
        const double size = sizeOf(block);
        extent.smallest = std::min(extent.smallest, size);
        extent.heaviest = std::max(extent.heaviest, material.density * gravity * size * size);
        density = std::max(density, material.density);
        for (const Point& p : block.points) {
            top = std::min(top, down.dot(p));
            bottom = std::max(bottom, down.dot(p));
        }
    }
    if (extent.any) extent.overburden = density * gravity * (bottom - top);
    return extent;
}

std::string shareText(double share) { return share < 10.0 ? rounded(100.0 * share) + " %" : rounded(share) + " times"; }

/// Warns of a stress [Pa] that strains the rock, or presses its contacts together, too far.
/// \param what the stress, as in `the weight of the rock`.
void checkStress(double stress, const std::string& what, const std::string& pointer, const RockExtent& extent,
                 CheckContext& context) {
    const double strain = stress / extent.soft;
    if (strain > mostStrain)
        context.report.warning(pointer,
                               what + ", " + pressureText(stress) + ", strains the material " +
                                   inQuotes(extent.softName) + " by up to " + shareText(strain) +
                                   ": results are meant for small strains, up to about " + shareText(mostStrain),
                               "Check the units of loads, 'density' and 'youngs_modulus'");
    const double ratio = numericsOf(context.scene.analysis).penaltyRatio, penetration = stress / (2.0 * ratio * extent.weakest);
    if (penetration > mostPenetration)
        context.report.warning(pointer == "/analysis/gravity" ? "/analysis/penalty_ratio" : pointer,
                               "contacts with the material " + inQuotes(extent.weakestName) + " are so soft that " +
                                   what + " presses blocks into each other by up to " + shareText(penetration) +
                                   " of their size",
                               "Give a larger 'penalty_ratio', or check 'youngs_modulus' of the softest material");
}

void checkWeight(const RockExtent& extent, CheckContext& context) {
    checkStress(extent.overburden, "the weight of the rock", "/analysis/gravity", extent, context);
    const double slip = extent.overburden / (2.0 * numericsOf(context.scene.analysis).penaltyRatio *
                                             context.scene.analysis.shearRatio * extent.weakest);
    if (slip > mostPenetration && context.scene.analysis.shearRatio < 1.0)
        context.report.warning("/analysis/shear_ratio",
                               "contacts are so soft in shear that blocks may move by up to " + shareText(slip) +
                                   " of their size along a joint before friction holds them",
                               "Give a larger 'shear_ratio'");
    const double closure = extent.heaviest / (2.0 * numericsOf(context.scene.analysis).penaltyRatio * extent.weakest);
    if (closure > mostOfSmallest * extent.smallest)
        context.report.warning("/analysis/penalty_ratio",
                               "the weight of the largest block presses contacts together by up to " +
                                   lengthText(closure) + ", and the smallest block measures only " +
                                   lengthText(extent.smallest),
                               "Leave out or merge small blocks, or give a larger 'penalty_ratio'");
}

/// Largest factor of a table of a load; 1 for an empty one.
double largestFactor(const Table& table) {
    double largest = table.empty() ? 1.0 : 0.0;
    for (const auto& [time, factor] : table) largest = std::max(largest, std::abs(factor));
    return largest;
}

double stressOf(const Load& load, const CheckContext& context) {
    const double factor = largestFactor(load.table);
    if (load.along) return factor * std::abs(load.pressure);
    const Point place = load.point ? *load.point : load.blockAt.value_or(Point(0.0, 0.0));
    const int block = blockWithPoint(context.scene, place);
    if (block < 0) return 0.0;
    return factor * load.force.norm() / (sizeOf(context.scene.blocks[block]) * context.scene.analysis.thickness);
}

/// \return the largest stress of all loads [Pa].
double checkLoadSizes(const Stage& stage, const std::string& pointer, const RockExtent& extent, CheckContext& context) {
    double largest = 0.0;
    for (std::size_t i = 0; i < stage.loads.size(); ++i) {
        const double stress = stressOf(stage.loads[i], context);
        largest = std::max(largest, stress);
        checkStress(stress, "the load", under(under(pointer, "loads"), i), extent, context);
    }
    return largest;
}

void checkInitialMotion(const InitialVelocity& initial, double step, const std::string& pointer,
                        const RockExtent& extent, CheckContext& context) {
    const int block = blockWithPoint(context.scene, initial.blockAt);
    if (block < 0) return;
    const Block& own = context.scene.blocks[block];
    const double size = sizeOf(own), speed = initial.velocity.norm();
    const double density = materialOf(context.scene, own).density;
    const double strain = speed * std::sqrt(density / extent.weakest);
    const double penetration = speed *
                               std::sqrt(density / (2.0 * numericsOf(context.scene.analysis).penaltyRatio * extent.weakest));
    if (speed * step > size)
        context.report.warning(under(pointer, "velocity"),
                               "the block moves by " + shareText(speed * step / size) +
                                   " of its size in a time step of " + rounded(step) +
                                   " s, which is too long for impacts of this block",
                               "Give a shorter 'time_step'");
    if (std::max(strain, penetration) > 2.0 * mostStrain)
        context.report.warning(under(pointer, "velocity"),
                               "an impact at " + rounded(speed) + " m/s deforms rock or contacts by up to about " +
                                   shareText(std::max(strain, penetration)) +
                                   " of the block's size: results are meant for small "
                                   "strains",
                               "Check the speed and 'youngs_modulus', or give a larger 'penalty_ratio'");
    const double centrifugal = density * std::pow(initial.spin * size, 2) /
                               materialOf(context.scene, own).youngsModulus;
    if (centrifugal > mostStrain)
        context.report.warning(under(pointer, "spin"),
                               "the spin strains the block by up to " + shareText(centrifugal) +
                                   ": results are meant for small "
                                   "strains",
                               "Check the spin [rad/s]");
    if (std::abs(initial.spin) * step > mostTurn)
        context.report.warning(under(pointer, "spin"),
                               "the block turns by " + rounded(std::abs(initial.spin) * step) +
                                   " rad in a time step of " + rounded(step) + " s",
                               "Give a shorter 'time_step'");
}

void checkMotionOf(const Stage& stage, const std::string& pointer, const RockExtent& extent, CheckContext& context) {
    const double step = std::min(stage.timeStep.value_or(automaticTimeStep(context.scene, stage)), stage.duration);
    if (!(step > 0.0) || !std::isfinite(step)) return;
    const double fall = 0.5 * context.scene.analysis.gravity.norm() * step * step;
    if (fall > mostFall * extent.smallest)
        context.report.warning(
            under(pointer, "time_step"),
            "a block falls by " + lengthText(fall) + " in a time step of " + rounded(step) + " s from rest, " +
                shareText(fall / extent.smallest) + " of the size of the smallest block",
            "Give a 'time_step' of " +
                rounded(std::sqrt(2.0 * 0.01 * extent.smallest / context.scene.analysis.gravity.norm())) +
                " s or less");
    for (std::size_t i = 0; i < stage.initialVelocities.size(); ++i)
        checkInitialMotion(stage.initialVelocities[i], step, under(under(pointer, "initial_velocities"), i), extent,
                           context);
}

void checkStageSizes(const RockExtent& extent, CheckContext& context) {
    const Scene& scene = context.scene;
    double largest = extent.overburden;
    bool moves = false, hasMotions = scene.inSituStress.has_value();
    for (const Block& block : scene.blocks)
        for (const double stress : block.initialStress) largest = std::max(largest, std::abs(stress));
    for (std::size_t i = 0; i < scene.stages.size(); ++i) {
        const Stage& stage = scene.stages[i];
        const std::string pointer = under("/stages", i);
        largest = std::max(largest, checkLoadSizes(stage, pointer, extent, context));
        hasMotions = hasMotions || !stage.motions.empty() || !stage.dilations.empty() || stage.bodyAcceleration;
        moves = moves || stage.kind == StageKind::Dynamic;
        if (stage.kind == StageKind::Dynamic) checkMotionOf(stage, pointer, extent, context);
    }
    if (largest > 0.0 && largest < leastStrain * extent.soft && !moves && !hasMotions)
        context.report.warning("/stages",
                               "the loads strain the rock by less than " + rounded(leastStrain) +
                                   ": displacements and contact forces are lost in round-off",
                               "Check the units of loads, 'density' and 'youngs_modulus'");
}

}  // namespace

void checkStiffness(CheckContext& context) {
    if (!context.allSound() || hasErrors(context.report.problems)) return;
    const RockExtent extent = extentOf(context);
    if (!extent.any) return;
    checkWeight(extent, context);
    checkStageSizes(extent, context);
}

}  // namespace keyblock
