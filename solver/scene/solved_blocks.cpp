// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/solved_blocks.h"

#include "geometry/segment.h"
#include "solver/scene/lookup.h"
#include "solver/scene/plate_place.h"

namespace keyblock {
namespace {

std::vector<Point> relative(const std::vector<Point>& points, const Point& origin) {
    std::vector<Point> moved;
    moved.reserve(points.size());
    for (const Point& p : points) moved.push_back(p - origin);
    return moved;
}

/// Adds the length of a bonded interface to the edge on which it lies.
void addGlued(const SharedEdge& shared, const std::vector<Point>& points, double tolerance,
              std::vector<double>& lengths) {
    const Point middle = 0.5 * (shared.from + shared.to);
    for (std::size_t e = 0; e < points.size(); ++e)
        if (distanceToSegment(points[e], points[(e + 1) % points.size()], middle) <= tolerance) {
            lengths[e] += (shared.to - shared.from).norm();
            return;
        }
}

void markInner(const std::vector<SharedEdge>& shared, std::size_t first, double tolerance, SolvedBlocks& all) {
    constexpr double whole = 1.0 - 1e-6;
    std::vector<std::vector<double>> lengths;
    for (std::size_t i = first; i < all.blocks.size(); ++i) lengths.emplace_back(all.blocks[i].points.size(), 0.0);
    for (const SharedEdge& edge : shared)
        for (int cell : {edge.a, edge.b}) {
            const std::size_t c = cell;
            addGlued(edge, all.blocks[first + c].points, 10.0 * tolerance, lengths[c]);
        }
    for (std::size_t c = 0; c < lengths.size(); ++c) {
        SolvedBlock& cell = all.blocks[first + c];
        for (std::size_t e = 0; e < cell.points.size(); ++e) {
            const double length = (cell.points[(e + 1) % cell.points.size()] - cell.points[e]).norm();
            cell.inner.push_back(lengths[c][e] >= whole * length);
        }
    }
}

void addCells(const Scene& scene, int block, double tolerance, SolvedBlocks& all) {
    const Block& own = scene.blocks[block];
    const SubBlocks cut = cutIntoCells(relative(own.points, all.origin), own.subBlocks->size, tolerance);
    const auto first = all.blocks.size();
    const std::string name = displayName(scene, block);
    for (const std::vector<Point>& cell : cut.cells) {
        SolvedBlock& solved = all.blocks.emplace_back();
        solved.name = name + ":" + std::to_string(all.blocks.size() - first);
        solved.block = block;
        solved.cell = true;
        solved.points = cell;
    }
    markInner(cut.shared, first, tolerance, all);
    for (SharedEdge edge : cut.shared) {
        edge.a += static_cast<int>(first);
        edge.b += static_cast<int>(first);
        all.glued.push_back(edge);
    }
}

void addPlates(const Scene& scene, SolvedBlocks& all) {
    for (std::size_t i = 0; i < scene.bolts.size(); ++i) {
        const Bolt& bolt = scene.bolts[i];
        if (bolt.plate != PlateKind::Block) continue;
        const PlatePlace place = placePlate(scene, bolt);
        SolvedBlock& solved = all.blocks.emplace_back();
        solved.name = bolt.name + ":plate";
        solved.block = place.block;
        solved.plateOf = static_cast<int>(i);
        solved.points = relative(place.outline, all.origin);
    }
}

}  // namespace

SolvedBlocks solvedBlocks(const Scene& scene) {
    SolvedBlocks all;
    if (!scene.blocks.empty() && !scene.blocks.front().points.empty()) all.origin = scene.blocks.front().points.front();
    const double tolerance = geometricTolerance(scene);
    for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
        const int block = static_cast<int>(i);
        all.firstOf.push_back(static_cast<int>(all.blocks.size()));
        if (scene.blocks[i].subBlocks) {
            addCells(scene, block, tolerance, all);
            continue;
        }
        SolvedBlock& solved = all.blocks.emplace_back();
        solved.name = displayName(scene, block);
        solved.block = block;
        solved.points = relative(scene.blocks[i].points, all.origin);
    }
    all.firstOf.push_back(static_cast<int>(all.blocks.size()));
    addPlates(scene, all);
    return all;
}

std::vector<std::string> blockNames(const Scene& scene) {
    std::vector<std::string> names;
    for (SolvedBlock& block : solvedBlocks(scene).blocks) names.push_back(std::move(block.name));
    return names;
}

std::vector<std::size_t> cornerCounts(const Scene& scene) {
    std::vector<std::size_t> counts;
    for (const SolvedBlock& block : solvedBlocks(scene).blocks) counts.push_back(block.points.size());
    return counts;
}

}  // namespace keyblock
