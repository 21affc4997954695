// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that the sub-blocks are of a reasonable number, that plates modelled
// as blocks lie on a face, and that no two blocks have the same name.
#include "geometry/polygon.h"
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/plate_place.h"
#include "solver/scene/pointer.h"
#include "solver/scene/solved_blocks.h"
#include "solver/scene/suggest.h"

#include <cmath>

namespace keyblock {

namespace {

constexpr double fewestCells = 1.5;

// False if the block would have too many cells.
bool checkCells(const Block& block, const std::string& pointer, CheckReport& report) {
    const double size = block.subBlocks->size;
    if (!(size > 0.0) || !std::isfinite(size))
        return false;  // already reported by the field check
    const double cells = gridCells(block.points, size);
    if (cells > mostCells)
        report.error(under(under(pointer, "sub_blocks"), "size"),
                     "cells of " + shortest(size) + " m are about " + shortest(std::round(cells)) +
                         " in this block; the limit is 1000000",
                     "Give a larger size");
    else if (cells < fewestCells)
        report.warning(under(under(pointer, "sub_blocks"), "size"),
                       "the block is not larger than a cell, so it is not divided",
                       "Give a smaller size, or omit sub_blocks");
    return cells <= mostCells;
}

std::string fault(const PlatePlace& place) {
    switch (place.fault) {
        case PlateFault::NoFace:
            return "the plate is a block and needs a face to lie on, but the head lies " + rounded(place.away) +
                   " m from the nearest face";
        case PlateFault::Corner: return "the head lies on a corner, so the plate could lie on either face";
        case PlateFault::InRock: return "the plate would overlap rock on every face at the head";
        case PlateFault::Behind: return "the bolt does not leave the rock through the face that its plate would lie on";
        case PlateFault::None: break;
    }
    return "";
}

std::string remedy(PlateFault what) {
    if (what == PlateFault::Behind)
        return "Swap far_end and head, or move the head to the face where the bolt leaves the rock";
    return "Put the head on a face, at least half a plate's width away from corners, or write \"plate\": \"spring\"";
}

// Outline of the plate; empty if there is an error.
std::vector<Point> checkPlate(const Bolt& bolt, const std::string& pointer, CheckContext& context) {
    const PlatePlace place = placePlate(context.scene, bolt);
    const std::string where = bolt.pattern < 0 ? under(pointer, "head") : under(pointer, "plate");
    if (place.fault != PlateFault::None) {
        context.report.error(where, fault(place), remedy(place.fault));
        return {};
    }
    const double width = boltTypeOf(context.scene, bolt).plate.width;
    if (place.overhang > 1e-6 * width)
        context.report.warning(where,
                               "there is no face behind " + rounded(place.overhang) + " m of the plate's width of " +
                                   shortest(width) + " m",
                               "Move the head away from the end of the face");
    return place.outline;
}

void checkPlates(CheckContext& context) {
    std::vector<std::pair<std::size_t, std::vector<Point>>> plates;
    for (std::size_t i = 0; i < context.scene.bolts.size(); ++i) {
        const Bolt& bolt = context.scene.bolts[i];
        if (bolt.plate != PlateKind::Block || !findBoltType(context.scene, bolt.type) || !bolt.head.allFinite() ||
            !bolt.farEnd.allFinite() || lengthOf(bolt) <= context.tolerance)
            continue;
        const std::string pointer = boltPointer(context.scene, i);
        std::vector<Point> outline = checkPlate(bolt, pointer, context);
        if (outline.empty())
            continue;
        for (const auto& [other, taken] : plates)
            if (overlap(taken, outline, context.tolerance))
                context.report.error(under(pointer, "head"),
                                     "its plate overlaps the plate of bolt " + inQuotes(context.scene.bolts[other].name),
                                     "Move the heads apart, or write \"plate\": \"spring\"");
        plates.emplace_back(i, std::move(outline));
    }
}

bool hasBodies(const Scene& scene) {
    for (const Block& block : scene.blocks)
        if (block.subBlocks) return true;
    for (const Bolt& bolt : scene.bolts)
        if (bolt.plate == PlateKind::Block) return true;
    return false;
}

}  // namespace

void checkBodies(CheckContext& context) {
    if (!hasBodies(context.scene) || !context.allSound())
        return;
    bool makes = true;
    for (std::size_t i = 0; i < context.scene.blocks.size(); ++i)
        if (context.scene.blocks[i].subBlocks)
            makes = checkCells(context.scene.blocks[i], under("/blocks", i), context.report) && makes;
    checkPlates(context);
    for (const Problem& problem : context.report.problems)
        makes = makes && problem.severity != Severity::Error;
    if (!makes)
        return;
    const SolvedBlocks solved = solvedBlocks(context.scene);
    const auto pointerOf = [&](std::size_t row) {
        const SolvedBlock& block = solved.blocks[row];
        return block.plateOf >= 0
                   ? under(boltPointer(context.scene, static_cast<std::size_t>(block.plateOf)), "name")
                   : under(blockPointer(context.scene, static_cast<std::size_t>(block.block)), "name");
    };
    checkNamesDiffer(
        solved.blocks.size(), [&](std::size_t row) { return solved.blocks[row].name; }, pointerOf, "block",
        context.report);
}

}  // namespace keyblock
