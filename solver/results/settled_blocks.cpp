// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/settled_blocks.h"

#include "geometry/polygon.h"

#include <algorithm>
#include <ranges>

namespace keyblock {

std::optional<Point> wholeDisplacement(const Scene& scene, const SolvedBlocks& solved, const Frame& frame, int first) {
    const int block = solved.blocks[first].block;
    Point sum(0.0, 0.0);
    double area = 0.0;
    for (std::size_t row = first; row < frame.blocks.size(); ++row) {
        if (solved.blocks[row].block != block || solved.blocks[row].plateOf >= 0) continue;
        sum += frame.blocks[row].area * frame.blocks[row].centroid;
        area += frame.blocks[row].area;
    }
    if (area == 0.0) return std::nullopt;
    return sum / area - moments(scene.blocks[block].points).centroid;
}

std::vector<int> settledBlocks(const RunSource& run, const Verdict& verdict) {
    std::vector<int> settled;
    const std::vector<StageRecord> records = run.stages();
    const auto last = std::ranges::find_if(records.rbegin(), records.rend(), &StageRecord::ended);
    if (verdict.blocks.empty() || last == records.rend() || run.frames().empty()) return settled;
    const SolvedBlocks solved = solvedBlocks(run.scene());
    const Frame frame = run.frame(run.frames().size() - 1);
    for (const StageUnstable& one : verdict.blocks) {
        const int first = one.block.block;
        if (std::ranges::count(last->result.unstable, first, &UnstableBlock::block) > 0) continue;
        const std::vector<Point>& points = run.scene().blocks[solved.blocks[first].block].points;
        const Point centre = moments(points).centroid;
        double size = 0.0;
        for (const Point& point : points) size = std::max(size, (point - centre).norm());
        const auto moved = wholeDisplacement(run.scene(), solved, frame, first);
        if (moved && moved->norm() <= settledShare * size) settled.push_back(first);
    }
    return settled;
}

}  // namespace keyblock
