// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/cut/cut_property.h"

#include "geometry/orientation.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

namespace keyblock {
namespace {

double sizeOf(const CutInput& input) {
    Box all = boxOf(input.domains.front().outline);
    for (const CutDomain& domain : input.domains) {
        const Box own = boxOf(domain.outline);
        all = {all.min.cwiseMin(own.min), all.max.cwiseMax(own.max)};
    }
    return (all.max - all.min).maxCoeff();
}

template <class... Words>
std::string words(const Words&... parts) {
    std::ostringstream text;
    text.precision(17);
    (text << ... << parts);
    return text.str();
}

/// True when edges meet but at the corner between them. Long outlines are left to the sum of areas.
bool meetsItself(const std::vector<Point>& outline) {
    const std::size_t count = outline.size();
    const auto at = [&](std::size_t i) -> const Point& { return outline[i % count]; };
    for (std::size_t i = 0; i < count && count <= 500; ++i) {
        if (orientation(at(i), at(i + 1), at(i + 2)) == 0 && (at(i) - at(i + 1)).dot(at(i + 2) - at(i + 1)) >= 0.0)
            return true;
        for (std::size_t j = i + 2; j < count; ++j)
            if ((j + 1) % count != i && segmentsMeet(at(i), at(i + 1), at(j), at(j + 1))) return true;
    }
    return false;
}

std::string brokenRing(const Cut& cut, const CutRing& ring, bool outer) {
    const std::vector<Point> outline = outlineOf(cut, ring);
    if (ring.vertices.size() < 3 || ring.sources.size() != ring.vertices.size()) return "a ring of two corners";
    if (std::set<int>(ring.vertices.begin(), ring.vertices.end()).size() != ring.vertices.size())
        return "a ring with a pinch";
    if (*std::min_element(ring.vertices.begin(), ring.vertices.end()) != ring.vertices.front())
        return "a ring that does not begin at its lowest corner";
    if ((signedArea(outline) > 0.0) != outer) return "a ring that runs the wrong way";
    return meetsItself(outline) ? words("a ring meets itself near ", outline.front().transpose()) : std::string();
}

std::string brokenBlock(const Cut& cut, const CutBlock& block) {
    if (std::string broken = brokenRing(cut, block.outer, true); !broken.empty()) return broken;
    double area = signedArea(outlineOf(cut, block.outer));
    for (const CutRing& hole : block.holes) {
        if (std::string broken = brokenRing(cut, hole, false); !broken.empty()) return broken;
        area += signedArea(outlineOf(cut, hole));
    }
    if (!(std::abs(area - block.area) <= 1e-9 * area)) return "a block that tells another area";
    return {};
}

std::string brokenAreas(const CutInput& input, const Cut& cut) {
    std::map<int, double> ofBlocks, ofDomains, rounding;
    double farthest = 0.0;
    for (const Point& p : cut.vertices) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    for (const CutDomain& domain : input.domains) ofDomains[domain.id] += std::abs(signedArea(domain.outline));
    for (const CutBlock& block : cut.blocks) {
        ofBlocks[block.domain] += block.area;
        // a corner is rounded by at most half its last digit in x and in y; an area changes by no more than that way
        // times the perimeter
        const double perimeter = 2.0 * block.area / block.width, lastHalf = 0.5 * std::numeric_limits<double>::epsilon();
        rounding[block.domain] += std::sqrt(2.0) * lastHalf * farthest * perimeter;
    }
    for (const auto& [id, area] : ofDomains) {
        const double allowed = 1e-12 * area + (farthest > 100.0 * sizeOf(input) ? rounding[id] : 0.0);
        if (!(std::abs(ofBlocks[id] - area) <= allowed))
            return words("blocks of domain ", id, " have ", ofBlocks[id], " of ", area);
    }
    return {};
}

std::string brokenLimits(const Cut& cut) {
    std::size_t kept = 0, under = 0;
    for (const CutNote& note : cut.notes) kept += note.kind == CutNoteKind::KeptSliver;
    for (const CutBlock& block : cut.blocks)
        under += block.area < cut.minArea * (1.0 - 1e-9) || block.width < cut.minWidth * (1.0 - 1e-9);
    return under > kept ? words(under, " blocks under a limit, ", kept, " of them noted") : std::string();
}

/// V − E + F = 1 + C of the blocks, every inner edge has a block on both sides and every border edge one.
std::string brokenEuler(const Cut& cut) {
    std::map<std::pair<int, int>, int> sides;  // of directed edges
    int borders = 0;
    const auto add = [&](const CutRing& ring) {
        for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
            ++sides[{ring.vertices[i], ring.vertices[(i + 1) % ring.vertices.size()]}];
            borders += ring.sources[i] == borderSource;
        }
    };
    for (const CutBlock& block : cut.blocks) {
        add(block.outer);
        for (const CutRing& hole : block.holes) add(hole);
    }
    std::vector<int> parent(cut.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[v] != v) v = parent[v];
        return v;
    };
    std::map<int, int> outside;  // the next vertex of edges with no block on their left
    int edges = 0;
    bool pinched = false;
    for (const auto& [edge, count] : sides) {
        if (count != 1) return "an edge with two blocks on one side";
        const bool twin = sides.count({edge.second, edge.first}) > 0;
        edges += !twin || edge.first < edge.second;
        if (!twin) pinched = !outside.emplace(edge.second, edge.first).second || pinched;
        parent[std::max(root(edge.first), root(edge.second))] =
            std::min(root(edge.first), root(edge.second));
    }
    if (pinched) return {};  // domains that touch in a corner: the faces outside cannot be counted like this
    int components = 0, outer = 0;
    for (std::size_t v = 0; v < parent.size(); ++v) components += parent[v] == static_cast<int>(v);
    const auto at = [&](int v) -> const Point& { return cut.vertices[v]; };
    std::set<int> walked;
    for (const auto& [from, to] : outside) {
        if (walked.count(from)) continue;
        double area = 0.0;
        for (int v = from; walked.insert(v).second; v = outside.at(v))
            area += cross(at(v) - at(from), at(outside.at(v)) - at(from));
        outer += area > 0.0;  // a gap that domains enclose
    }
    const auto vertices = static_cast<int>(cut.vertices.size());
    const int faces = static_cast<int>(cut.blocks.size()) + outer + 1;
    if (vertices - edges + faces != 1 + components)
        return words("Euler: ", vertices, " - ", edges, " + ", faces, " is not 1 + ", components);
    return {};
}

std::string difference(const Cut& a, const Cut& b) {
    if (a.vertices != b.vertices) return words(a.vertices.size(), " vertices, shuffled ", b.vertices.size());
    if (a.blocks.size() != b.blocks.size()) return words(a.blocks.size(), " blocks, shuffled ", b.blocks.size());
    const auto same = [](const CutRing& p, const CutRing& q) {
        return p.vertices == q.vertices && p.sources == q.sources;
    };
    for (std::size_t i = 0; i < a.blocks.size(); ++i) {
        const CutBlock &p = a.blocks[i], &q = b.blocks[i];
        if (p.domain != q.domain || !same(p.outer, q.outer) || p.area != q.area || p.width != q.width ||
            !std::equal(p.holes.begin(), p.holes.end(), q.holes.begin(), q.holes.end(), same))
            return words("block ", i, " differs when shuffled");
    }
    return {};
}

}  // namespace

Cut cutIntoBlocks(const CutInput& input) { return cutIntoBlocks(input.domains, input.traces, input.settings); }

CutInput shuffled(const CutInput& input, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    CutInput other = input;
    const std::size_t count = input.traces.size();
    for (std::size_t i = 0; i < count; ++i)
        if (random() % 8 == 0) other.traces.push_back(other.traces[i]);
    for (CutTrace& trace : other.traces)
        if (random() % 2) std::swap(trace.from, trace.to);
    std::shuffle(other.traces.begin(), other.traces.end(), random);
    std::shuffle(other.domains.begin(), other.domains.end(), random);
    for (CutDomain& domain : other.domains) {
        if (domain.outline.empty()) continue;
        const auto turn = static_cast<std::ptrdiff_t>(random() % domain.outline.size());
        std::rotate(domain.outline.begin(), domain.outline.begin() + turn, domain.outline.end());
        if (random() % 2) std::reverse(domain.outline.begin(), domain.outline.end());
    }
    return other;
}

std::vector<Point> outlineOf(const Cut& cut, const CutRing& ring) {
    std::vector<Point> outline;
    for (int vertex : ring.vertices) outline.push_back(cut.vertices[vertex]);
    return outline;
}

std::string brokenCut(const CutInput& input) {
    const Cut cut = cutIntoBlocks(input);
    for (const CutBlock& block : cut.blocks)
        if (std::string broken = brokenBlock(cut, block); !broken.empty()) return broken;
    if (std::string broken = brokenAreas(input, cut); !broken.empty()) return broken;
    if (std::string broken = brokenLimits(cut); !broken.empty()) return broken;
    CutInput other = shuffled(input, 1);
    if (std::string broken = difference(cut, cutIntoBlocks(other)); !broken.empty()) return broken;
    other.settings.keepStraight = true;
    const Cut whole = cutIntoBlocks(other);
    if (whole.blocks.size() != cut.blocks.size()) return "other blocks with all their vertices";
    return brokenEuler(whole);
}

}  // namespace keyblock
