// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cell starts as the box and loses the parts that are nearer to other sites, the nearest sites first. It is complete
// when no further site is within twice the distance of its farthest corner, because only such a site could cut off
// more. Each edge keeps the name of the site behind it. The names of two adjacent edges and of the cell itself identify
// a corner.
#include "geometry/cells/site_cells.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

namespace keyblock {
namespace {

constexpr int borderName = -1;

struct Corner {
    Point p{0.0, 0.0};
    int behind = borderName;  // the site behind the edge that starts here
};

/// The sites, sorted into square bins.
class Bins {
public:
    Bins(std::span<const Point> sites, double spacing) : box_(boxOf(sites)) {
        const Point extent = box_.max - box_.min;
        const double squares = 4.0 * static_cast<double>(sites.size());  // approximate maximum; most are empty
        width_ = std::max({spacing, std::sqrt(extent.x() * extent.y() / squares), extent.maxCoeff() / squares});
        columns_ = static_cast<long>(extent.x() / width_) + 1;
        rows_ = static_cast<long>(extent.y() / width_) + 1;
        members_.resize(columns_ * rows_);
        for (std::size_t i = 0; i < sites.size(); ++i)
            members_[index(column(sites[i]), row(sites[i]))].push_back(static_cast<int>(i));
    }

    /// Calls visit(site) for the sites in the ring of squares that is `ring` squares away from the square of `p`.
    /// \return false if there are no squares that far away.
    template <class Visit>
    bool visitRing(const Point& p, long ring, Visit visit) const {
        const long c = column(p), r = row(p);
        if (ring > std::max({c, columns_ - 1 - c, r, rows_ - 1 - r})) return false;
        for (long j = std::max(r - ring, 0L); j <= std::min(r + ring, rows_ - 1); ++j) {
            const long step = std::abs(j - r) == ring || ring == 0 ? 1 : 2 * ring;
            for (long i = c - ring; i <= c + ring; i += step) {
                if (i < 0 || i >= columns_) continue;
                for (const int site : members_[index(i, j)]) visit(site);
            }
        }
        return true;
    }

    double width() const { return width_; }

private:
    long column(const Point& p) const { return place(p.x() - box_.min.x(), columns_); }
    long row(const Point& p) const { return place(p.y() - box_.min.y(), rows_); }
    long place(double off, long n) const {
        return static_cast<long>(std::clamp(off / width_, 0.0, static_cast<double>(n - 1)));
    }
    std::size_t index(long i, long j) const { return j * columns_ + i; }

    Box box_;
    double width_ = 0.0;  // [m]
    long columns_ = 1, rows_ = 1;
    std::vector<std::vector<int>> members_;
};

/// Cuts off the part of the cell that is nearer to `other` than to `own`.
void keepNearer(std::vector<Corner>& cell, const Point& own, const Point& other, int name) {
    const Point across = other - own, middle = 0.5 * (own + other);
    const auto beyond = [&](const Corner& corner) { return across.dot(corner.p - middle); };
    if (std::all_of(cell.begin(), cell.end(), [&](const Corner& c) { return beyond(c) <= 0.0; })) return;
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const Corner& a = cell[i];
        const Corner& b = cell[(i + 1) % cell.size()];
        const double offA = beyond(a), offB = beyond(b);
        if (offA <= 0.0) kept.push_back(a);
        if ((offA <= 0.0) == (offB <= 0.0)) continue;
        const Point place = a.p + offA / (offA - offB) * (b.p - a.p);
        kept.push_back({place, offA <= 0.0 ? name : a.behind});
    }
    cell = std::move(kept);
}

double farthest(const std::vector<Corner>& cell, const Point& from) {
    double distance = 0.0;
    for (const Corner& corner : cell) distance = std::max(distance, (corner.p - from).norm());
    return distance;
}

std::vector<Corner> cellOf(std::span<const Point> sites, int own, const Bins& bins, const Box& bounds) {
    const Point& site = sites[own];
    std::vector<Corner> cell{{bounds.min}, {{bounds.max.x(), bounds.min.y()}}, {bounds.max},
                             {{bounds.min.x(), bounds.max.y()}}};
    const auto cut = [&](int other) {
        if (other != own) keepNearer(cell, site, sites[other], other);
    };
    for (long ring = 0; bins.visitRing(site, ring, cut); ++ring)
        if (static_cast<double>(ring) * bins.width() >= 2.0 * farthest(cell, site)) break;
    return cell;
}

/// The centre of the circle through three points; not finite if they are collinear.
Point circleCentre(const Point& a, const Point& b, const Point& c) {
    const Point u = b - a, v = c - a;
    const Point w = u.squaredNorm() * v - v.squaredNorm() * u;
    return a - turnLeft(w) / (2.0 * cross(u, v));
}

/// The position of the corner, computed identically for all three cells.
Point commonPlace(std::span<const Point> sites, std::array<int, 3> names, const Point& own, double spacing) {
    const auto site = [&](int i) { return sites[names[i]]; };
    const Point centre = circleCentre(site(0), site(1), site(2));
    // Three nearly collinear sites have a distant centre with few significant digits. There each cell keeps its own
    // corner.
    return (centre - own).norm() <= 1e-3 * spacing ? centre : own;
}

}  // namespace

SiteCells siteCells(std::span<const Point> sites, const Box& bounds, double spacing, double tolerance) {
    assert(spacing > 0.0);
    const Bins bins(sites, spacing);
    SiteCells result{PointSet(tolerance), {}};
    std::map<std::array<int, 3>, int> named;
    for (int s = 0; s < static_cast<int>(sites.size()); ++s) {
        const std::vector<Corner> cell = cellOf(sites, s, bins, bounds);
        std::vector<int> ring;
        for (std::size_t i = 0; i < cell.size(); ++i) {
            std::array<int, 3> names{s, cell[(i + cell.size() - 1) % cell.size()].behind, cell[i].behind};
            std::sort(names.begin(), names.end());
            int number = -1;
            if (names[0] == borderName) {
                number = result.corners.number(cell[i].p);
            } else {
                const auto found = named.find(names);
                number = found != named.end()
                             ? found->second
                             : result.corners.number(commonPlace(sites, names, cell[i].p, spacing));
                named.try_emplace(names, number);
            }
            if (ring.empty() || ring.back() != number) ring.push_back(number);
        }
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        result.rings.push_back(std::move(ring));
    }
    return result;
}

}  // namespace keyblock
