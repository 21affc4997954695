// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cut/near_ends.h"

#include "geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace keyblock {
namespace {

/// Points in cells that are eight radii wide, so that most neighbourhoods lie within one cell.
class PlaceCells {
public:
    PlaceCells(double radius, std::size_t count) : radius_(radius), cell_(8.0 * radius) { first_.reserve(2 * count); }

    void add(const Point& p, int place) {
        next_.push_back(-1);
        auto [entry, isNew] = first_.try_emplace(key(index(p.x()), index(p.y())), place);
        if (!isNew) next_.back() = std::exchange(entry->second, place);
    }

    /// Index of the nearest place within the radius (of several equally near ones, the first); −1 if there is none.
    int nearest(const std::vector<Point>& places, const Point& p) const {
        int best = -1;
        double least = radius_;
        for (std::int64_t column = index(p.x() - radius_); column <= index(p.x() + radius_); ++column)
            for (std::int64_t row = index(p.y() - radius_); row <= index(p.y() + radius_); ++row) {
                const auto entry = first_.find(key(column, row));
                for (int i = entry == first_.end() ? -1 : entry->second; i >= 0; i = next_[i])
                    if (const double distance = (places[i] - p).norm();
                        distance < least || (distance == least && (best < 0 || i < best))) {
                        least = distance;
                        best = i;
                    }
            }
        return best;
    }

private:
    std::int64_t index(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }
    /// Different cells may share a key; that only costs time.
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        std::uint64_t mixed = static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15u;
        mixed += static_cast<std::uint64_t>(row);
        mixed ^= mixed >> 32;
        return mixed * 0xD6E8FEB86659FD93u;
    }

    double radius_, cell_;
    std::unordered_map<std::uint64_t, int> first_;
    std::vector<int> next_;
};

/// Points sorted into the cells of a grid over a box.
class PointGrid {
public:
    PointGrid(std::span<const Point> points, const Box& box, double radius) : origin_(box.min), radius_(radius) {
        const Point side = (box.max - box.min).cwiseMax(radius);
        const double wanted = std::sqrt(side.x() * side.y() / static_cast<double>(points.size() + 1));
        cell_ = std::max({wanted, 4.0 * radius, side.maxCoeff() / 2048.0});
        columns_ = 1 + static_cast<int>(side.x() / cell_);
        rows_ = 1 + static_cast<int>(side.y() / cell_);
        start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
        std::vector<std::pair<std::size_t, int>> own;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const Point& p = points[i]; meets(box, {p, p}))
                own.emplace_back(cellAt(column(p.x()), row(p.y())), static_cast<int>(i));
        for (const auto& [cell, i] : own) ++start_[cell + 1];
        for (std::size_t cell = 1; cell < start_.size(); ++cell) start_[cell] += start_[cell - 1];
        entries_.resize(own.size());
        std::vector<int> at(start_.begin(), start_.end() - 1);
        for (const auto& [cell, i] : own)
            entries_[at[cell]++] = {points[i], i};
    }

    /// Calls `visit(i)` for each point within the radius of the segment a–b.
    template <class Visit>
    void visitNear(Point a, Point b, Visit visit) const {
        if (a.x() > b.x()) std::swap(a, b);
        const double slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0.0;
        const int last = column(b.x() + radius_);
        for (int c = column(a.x() - radius_); c <= last; ++c) {
            const double left = std::clamp(origin_.x() + c * cell_ - radius_, a.x(), b.x());
            const double right = std::clamp(origin_.x() + (c + 1) * cell_ + radius_, a.x(), b.x());
            double low = a.y() + (left - a.x()) * slope, high = a.y() + (right - a.x()) * slope;
            if (left == a.x()) low = a.y();
            if (right == b.x()) high = b.y();
            if (b.x() - a.x() <= 2.0 * radius_) low = a.y(), high = b.y();  // practically vertical
            if (low > high) std::swap(low, high);
            visitCells(c, row(low - 2.0 * radius_), row(high + 2.0 * radius_), a, b, visit);
        }
    }

private:
    struct Entry {
        Point place{0.0, 0.0};
        int point = 0;
    };

    template <class Visit>
    void visitCells(int c, int firstRow, int lastRow, const Point& a, const Point& b, Visit visit) const {
        const int first = start_[cellAt(c, firstRow)], end = start_[cellAt(c, lastRow) + 1];  // rows are contiguous
        const Point chord = b - a;
        const double reach = radius_ * radius_ * chord.squaredNorm() * (1.0 + 1e-9);
        for (int k = first; k < end; ++k) {
            const Entry& entry = entries_[k];
            const double off = cross(chord, entry.place - a);
            if (off * off <= reach && distanceToSegment(a, b, entry.place) <= radius_) visit(entry.point);
        }
    }
    int column(double x) const { return within((x - origin_.x()) / cell_, columns_); }
    int row(double y) const { return within((y - origin_.y()) / cell_, rows_); }
    static int within(double index, int count) { return static_cast<int>(std::clamp(index, 0.0, count - 1.0)); }
    std::size_t cellAt(int c, int r) const {
        return static_cast<std::size_t>(c) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(r);
    }

    Point origin_;
    double radius_, cell_ = 1.0;
    int columns_ = 1, rows_ = 1;
    std::vector<int> start_;  // index of the first entry of each cell
    std::vector<Entry> entries_;
};

/// A point and its sort keys.
struct Keyed {
    double first = 0.0, second = 0.0;
    int point = 0;
};

bool isLower(const Keyed& a, const Keyed& b) {
    if (a.first != b.first) return a.first < b.first;
    return a.second < b.second || (a.second == b.second && a.point < b.point);
}

/// Calls `visit(i, j)` for each pair of points within the radius of each other. The points are sorted along a direction
/// that is unlikely to be normal to the lines of a section, so that few points have nearly the same sort key.
template <class Visit>
void forEachClosePair(std::span<const Point> points, double radius, Visit visit) {
    const Point along(0.7986355, 0.6018150);
    std::vector<Keyed> order;
    order.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) order.push_back({along.dot(points[i]), 0.0, static_cast<int>(i)});
    std::sort(order.begin(), order.end(), isLower);
    const double window = 2.0 * radius;  // includes a margin for round-off of the dot product
    for (std::size_t k = 0; k < order.size(); ++k)
        for (std::size_t m = k + 1; m < order.size() && order[m].first - order[k].first <= window; ++m) {
            const int i = order[k].point, j = order[m].point;
            const Point apart = points[i] - points[j];
            if (apart.norm() <= radius) visit(i, j);
        }
}

}  // namespace

Gathered gather(std::span<const Point> points, std::size_t fixed, double radius) {
    Gathered result;
    PlaceCells cells(radius, points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        int place = cells.nearest(result.places, points[i]);
        if (place >= 0 && i < fixed && result.places[place] != points[i]) place = -1;
        if (place < 0) {
            place = static_cast<int>(result.places.size());
            result.places.push_back(points[i]);
            cells.add(points[i], place);
        }
        result.placeOf.push_back(place);
    }
    return result;
}

Gathered gatherSorted(std::span<const Point> points, std::size_t fixed, double radius) {
    const std::size_t count = points.size();
    std::vector<int> target(count);  // the point with which each point is merged; itself at the end of a chain
    std::iota(target.begin(), target.end(), 0);
    const auto end = [&](int i) {
        while (target[i] != i) i = target[i];
        return i;
    };
    const auto rank = [&](int i) {
        const Point& p = points[i];
        return std::tuple(static_cast<std::size_t>(i) >= fixed, p.x(), p.y(), i);
    };
    forEachClosePair(points, radius, [&](int i, int j) {
        const int a = end(i), b = end(j);
        const int first = rank(a) < rank(b) ? a : b;
        target[a] = target[b] = first;
    });
    std::vector<Keyed> order;
    for (std::size_t i = 0; i < count; ++i)
        if (target[i] == static_cast<int>(i)) order.push_back({points[i].x(), points[i].y(), static_cast<int>(i)});
    std::sort(order.begin(), order.end(), isLower);
    Gathered result;
    result.placeOf.assign(count, 0);
    result.places.reserve(order.size());
    for (const Keyed& own : order) {
        result.placeOf[own.point] = static_cast<int>(result.places.size());
        result.places.push_back(points[own.point]);
    }
    for (std::size_t i = 0; i < count; ++i)
        result.placeOf[i] = result.placeOf[end(static_cast<int>(i))];
    return result;
}

std::vector<std::pair<int, int>> nearPairs(std::span<const Point> places, std::span<const PlacePair> segments,
                                           const Box& box, double radius) {
    const PointGrid grid(places, grown(box, radius), radius);
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const PlacePair ends = segments[i];
        const Point& from = places[ends.from];
        grid.visitNear(from, places[ends.to], [&](int place) {
            if (place != ends.from && place != ends.to) pairs.emplace_back(place, static_cast<int>(i));
        });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace keyblock
