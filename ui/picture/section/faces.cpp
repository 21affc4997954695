// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An edge is divided at the corners of neighbouring blocks. A piece is free if no
// block lies just beyond its midpoint: it is then a wall or part of the domain's
// boundary.
#include "ui/picture/section/faces.h"

#include "geometry/grid.h"
#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

class Faces {
public:
    Faces(const Scene& scene, const SolvedBlocks& solved, const std::vector<std::vector<Point>>& corners,
          const std::vector<char>& present)
        : scene_(scene), solved_(solved), corners_(corners), present_(present), grid_(boxes(corners)) {
        Box all = boxOf(corners.front());
        for (const auto& outline : corners) {
            const Box box = boxOf(outline);
            all = {all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)};
        }
        near_ = 1e-6 * (all.max - all.min).norm();
    }

    std::vector<FacePiece> pieces() const {
        std::vector<FacePiece> found;
        for (std::size_t block = 0; block < corners_.size(); ++block)
            if (present_[block])
                for (std::size_t edge = 0; edge < corners_[block].size(); ++edge) addEdge(block, edge, found);
        return found;
    }

private:
    static std::vector<Box> boxes(const std::vector<std::vector<Point>>& corners) {
        std::vector<Box> all;
        for (const auto& outline : corners) all.push_back(boxOf(outline));
        return all;
    }

    void addEdge(std::size_t block, std::size_t edge, std::vector<FacePiece>& found) const {
        const Point& a = corners_[block][edge];
        const Point& b = corners_[block][(edge + 1) % corners_[block].size()];
        const std::vector<int> neighbours = neighboursOf(block, a, b);
        const Point outward = -turnLeft(b - a).normalized();
        const std::vector<double> places = partsOf(a, b, neighbours);
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            const Point middle = a + 0.5 * (places[i] + places[i + 1]) * (b - a);
            found.push_back({kindOf(block, middle, middle + 4.0 * near_ * outward, neighbours), static_cast<int>(block),
                             static_cast<int>(edge), places[i], places[i + 1]});
        }
    }

    std::vector<int> neighboursOf(std::size_t block, const Point& a, const Point& b) const {
        std::vector<int> met = grid_.meeting(grown({a.cwiseMin(b), a.cwiseMax(b)}, 10.0 * near_));
        std::erase_if(met, [&](int other) { return !present_[other] || other == static_cast<int>(block); });
        return met;
    }

    /// Points at which the edge is divided, as fractions of its length: 0 first and 1 last.
    std::vector<double> partsOf(const Point& a, const Point& b, const std::vector<int>& neighbours) const {
        std::vector<double> places{0.0, 1.0};
        const double length = (b - a).norm();
        for (const int other : neighbours)
            for (const Point& corner : corners_[other]) {
                const double place = (corner - a).dot(b - a) / (length * length);
                const bool inside = place * length > 4.0 * near_ && (1.0 - place) * length > 4.0 * near_;
                if (inside && distanceToSegment(a, b, corner) <= 2.0 * near_) places.push_back(place);
            }
        std::sort(places.begin(), places.end());
        const auto same = [&](double x, double y) { return (y - x) * length <= near_; };
        places.erase(std::unique(places.begin(), places.end(), same), places.end());
        return places;
    }

    FaceKind kindOf(std::size_t block, const Point& middle, const Point& beyond,
                    const std::vector<int>& neighbours) const {
        const SolvedBlock& own = solved_.blocks[block];
        for (const int other : neighbours) {
            if (locate(corners_[other], beyond, 0.0) == Side::Outside) continue;
            const bool seam = own.cell && solved_.blocks[other].cell && solved_.blocks[other].block == own.block;
            return seam ? FaceKind::Seam : FaceKind::Joint;
        }
        return liesOnBorder(own, middle) ? FaceKind::Border : FaceKind::Wall;
    }

    /// Whether `place` is on the domain's boundary, according to the faces of the scene's block (this block, or the one
    /// that it is a sub-block of).
    bool liesOnBorder(const SolvedBlock& own, const Point& place) const {
        if (own.plateOf >= 0) return false;
        const Block& block = scene_.blocks[own.block];
        for (std::size_t edge = 0; edge < block.faces.size(); ++edge) {
            const Point& a = block.points[edge];
            const Point& b = block.points[(edge + 1) % block.points.size()];
            if (block.faces[edge].side && distanceToSegment(a, b, place) <= 10.0 * near_) return true;
        }
        return false;
    }

    const Scene& scene_;
    const SolvedBlocks& solved_;
    const std::vector<std::vector<Point>>& corners_;
    const std::vector<char>& present_;
    BoxGrid grid_;
    double near_ = 0.0;  // [m] tolerance for edges that touch
};

}  // namespace

std::vector<FacePiece> facePieces(const Scene& scene, const SolvedBlocks& solved,
                                  const std::vector<std::vector<Point>>& corners, const std::vector<char>& present) {
    if (corners.empty()) return {};
    return Faces(scene, solved, corners, present).pieces();
}

}  // namespace keyblock
