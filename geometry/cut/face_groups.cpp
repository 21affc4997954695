// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cut/face_groups.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>

namespace keyblock {

FaceGroups::FaceGroups(const PlanarMap& map) : map_(map) {
    const std::size_t faces = map.faces;
    parent_.resize(faces);
    std::iota(parent_.begin(), parent_.end(), 0);
    nextFace_ = parent_;
    listHalfEdges();
    findDomains();
    measure();
}

int FaceGroups::groupOf(int face) const {
    auto& parent = parent_;
    std::size_t f = face;
    while (parent[f] != static_cast<int>(f)) {
        parent[f] = parent[parent[f]];
        f = static_cast<std::size_t>(parent[f]);
    }
    return static_cast<int>(f);
}

double FaceGroups::width(int group) const {
    const auto g = static_cast<std::size_t>(group);
    return perimeter_[g] > 0.0 ? 2.0 * area_[g] / perimeter_[g] : 0.0;
}

void FaceGroups::listHalfEdges() {
    start_.assign(static_cast<std::size_t>(map_.faces) + 1, 0);
    for (const HalfEdge& half : map_.halfEdges) ++start_[half.face + 1];
    for (std::size_t f = 1; f < start_.size(); ++f) start_[f] += start_[f - 1];
    ofFaces_.resize(map_.halfEdges.size());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (std::size_t h = 0; h < map_.halfEdges.size(); ++h)
        ofFaces_[next[map_.halfEdges[h].face]++] =
            static_cast<int>(h);
}

void FaceGroups::findDomains() {
    std::vector<Domains> domains(map_.faces, Domains{-1, -1});
    std::vector<char> seen(domains.size(), 0);
    std::vector<int> waiting{0};
    seen[0] = 1;
    while (!waiting.empty()) {
        const std::size_t face = waiting.back();
        waiting.pop_back();
        for (int k = start_[face]; k < start_[face + 1]; ++k) {
            const int half = ofFaces_[k];
            const std::size_t other = map_.halfEdges[half ^ 1].face;
            if (seen[other]) continue;
            seen[other] = 1;
            domains[other] = inOneOf(domains[face], map_.marks[half / 2].domains);
            waiting.push_back(static_cast<int>(other));
        }
    }
    for (const Domains& in : domains) domain_.push_back(in[0]);
}

void FaceGroups::measure() {
    area_.assign(map_.faces, 0.0);
    perimeter_ = area_;
    for (std::size_t e = 0; e < map_.marks.size(); ++e) {
        const HalfEdge &one = map_.halfEdges[2 * e], &two = map_.halfEdges[2 * e + 1];
        if (one.face == two.face) continue;
        const Point& from = map_.points[two.target];
        const Point& to = map_.points[one.target];
        const double twice = cross(from, to), length = (to - from).norm();
        area_[one.face] += 0.5 * twice;
        area_[two.face] -= 0.5 * twice;
        perimeter_[one.face] += length;
        perimeter_[two.face] += length;
    }
}

std::vector<FaceGroups::Neighbour> FaceGroups::neighbours(int group) const {
    struct Shared {
        int group;
        double length;
        int edge;
    };
    std::vector<Shared> shared;
    forEachHalfEdge(group, [&](int half) {
        const int other = groupAt(half ^ 1);
        if (other == group || domainOf(other) != domainOf(group)) return;
        const Point &from = startOf(half), &to = startOf(half ^ 1);
        shared.push_back({other, (to - from).norm(), half / 2});
    });
    std::sort(shared.begin(), shared.end(), [](const Shared& a, const Shared& b) {
        return std::tuple(a.group, -a.length, a.edge) < std::tuple(b.group, -b.length, b.edge);
    });
    std::vector<Neighbour> found;
    for (const Shared& one : shared) {
        if (found.empty() || found.back().group != one.group) found.push_back({one.group, 0.0, one.edge});
        found.back().length += one.length;
    }
    return found;
}

std::optional<FaceGroups::Neighbour> FaceGroups::longestNeighbour(int group) const {
    std::optional<Neighbour> best;
    for (const Neighbour& one : neighbours(group))
        if (!best || std::pair(one.length, area(one.group)) > std::pair(best->length, area(best->group))) best = one;
    return best;
}

int FaceGroups::join(int group, const Neighbour& neighbour) {
    const std::size_t first = std::min(group, neighbour.group);
    const std::size_t second = std::max(group, neighbour.group);
    parent_[second] = static_cast<int>(first);
    std::swap(nextFace_[first], nextFace_[second]);
    area_[first] += area_[second];
    perimeter_[first] = std::max(0.0, perimeter_[first] + perimeter_[second] - 2.0 * neighbour.length);
    return static_cast<int>(first);
}

std::vector<Sliver> joinSlivers(FaceGroups& groups, int faces, double minArea, double minWidth) {
    using Entry = std::pair<double, int>;  // area, group
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto addIfSmall = [&](int group) {
        if (groups.area(group) < minArea || groups.width(group) < minWidth) queue.emplace(groups.area(group), group);
    };
    for (int face = 1; face < faces; ++face)
        if (groups.domainOf(face) >= 0) addIfSmall(face);
    std::vector<Sliver> slivers;
    while (!queue.empty()) {
        const auto [area, group] = queue.top();
        queue.pop();
        if (groups.groupOf(group) != group || groups.area(group) != area) continue;  // has grown since
        int half = -1;
        groups.forEachHalfEdge(group, [&](int own) { half = half < 0 ? own : half; });
        const auto neighbour = groups.longestNeighbour(group);
        slivers.push_back({neighbour ? neighbour->edge : -1, half, area});
        if (neighbour) addIfSmall(groups.join(group, *neighbour));
    }
    return slivers;
}

}  // namespace keyblock
