// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/snap.h"

#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr std::size_t mostCrossed = 200;  // lines near the mouse that are intersected with each other

/// Penalty of a kind compared with ends, relative to the radius. Points come before lines at any distance.
double rankOf(SnapKind kind) {
    switch (kind) {
        case SnapKind::End: return 0.0;
        case SnapKind::Intersection: return 0.35;
        case SnapKind::Middle: return 0.7;
        case SnapKind::Foot: return 0.9;
        case SnapKind::OnLine: return 2.0;
        case SnapKind::Grid: break;
    }
    return 4.0;
}

bool hasCorners(ObjectKind kind) {
    return kind == ObjectKind::Domain || kind == ObjectKind::Region || kind == ObjectKind::Tunnel ||
           kind == ObjectKind::Block;
}

}  // namespace

/// One query: keeps the best candidate so far.
class SnapIndex::Search {
public:
    Search(const SnapIndex& index, const Point& place, const SnapWish& wish) : index_(index), place_(place), wish_(wish) {}

    std::optional<Snap> run() {
        if (wish_.objects && wish_.radius > 0.0) {
            for (const Mark& mark : index_.marks_) offer(mark.place, SnapKind::End, mark.object, -1, "");
            for (const Mark& mark : index_.middles_) offer(mark.place, SnapKind::Middle, mark.object, -1, "centre of ");
            lines();
        }
        if (!best_ && wish_.grid && *wish_.grid > 0.0) return onGrid();
        return best_ ? std::optional(named()) : std::nullopt;
    }

private:
    bool isLeftOut(int object) const {
        const std::string& pointer = index_.names_[object].pointer;
        return std::find(wish_.except.begin(), wish_.except.end(), pointer) != wish_.except.end();
    }

    void offer(const Point& point, SnapKind kind, int object, int other, const char* what) {
        const double distance = (point - place_).norm();
        if (!(distance <= wish_.radius) || isLeftOut(object)) return;
        const double score = distance / wish_.radius + rankOf(kind);
        if (best_ && score >= score_) return;
        const bool inRock = index_.names_[object].inRock;
        if (inRock && isInOpening(index_.openings_, point)) return;
        score_ = score, object_ = object, other_ = other, what_ = what;
        best_ = Snap{point, kind, {}, {}};
    }

    void lines() {
        if (!index_.grid_) return;
        const Box around = grown(Box{place_, place_}, wish_.radius);
        std::vector<const Line*> near;
        for (const int i : index_.grid_->meeting(around)) {
            const Line& line = index_.lines_[i];
            if (distanceToSegment(line.a, line.b, place_) <= wish_.radius && !isLeftOut(line.object)) near.push_back(&line);
        }
        for (const Line* line : near) points(*line);
        const std::size_t crossed = std::min(near.size(), mostCrossed);
        for (std::size_t i = 0; i < crossed; ++i)
            for (std::size_t j = i + 1; j < crossed; ++j) meet(*near[i], *near[j]);
    }

    void points(const Line& line) {
        const char* end = index_.names_[line.object].hasCorners ? "corner of " : "end of ";
        if (line.endA) offer(line.a, SnapKind::End, line.object, -1, end);
        if (line.endB) offer(line.b, SnapKind::End, line.object, -1, end);
        if (!line.curved) offer(0.5 * (line.a + line.b), SnapKind::Middle, line.object, -1, "midpoint of ");
        const double on = std::clamp(footParameter(line.a, line.b, place_), 0.0, 1.0);
        offer(line.a + on * (line.b - line.a), SnapKind::OnLine, line.object, -1, "on ");
        if (!wish_.previous) return;
        const double foot = footParameter(line.a, line.b, *wish_.previous);
        if (foot >= 0.0 && foot <= 1.0)
            offer(line.a + foot * (line.b - line.a), SnapKind::Foot, line.object, -1, "perpendicular to ");
    }

    void meet(const Line& one, const Line& two) {
        if (one.a == two.a || one.a == two.b || one.b == two.a || one.b == two.b) return;  // they share a corner
        if (const auto crossed = crossing(one.a, one.b, two.a, two.b))
            offer(crossed->place, SnapKind::Intersection, one.object, two.object, "intersection of ");
    }

    Snap named() const {
        Snap snap = *best_;
        const Name& name = index_.names_[object_];
        snap.pointer = name.pointer;
        snap.name = what_ + name.title;
        if (other_ >= 0 && other_ != object_) snap.name += " and " + index_.names_[other_].title;
        return snap;
    }

    std::optional<Snap> onGrid() const {
        const double spacing = *wish_.grid;
        const Point place = (place_ / spacing).array().round().matrix() * spacing;
        if (!place.allFinite()) return std::nullopt;
        return Snap{place + Point(0.0, 0.0), SnapKind::Grid, "grid", {}};
    }

    const SnapIndex& index_;
    const Point place_;
    const SnapWish& wish_;
    std::optional<Snap> best_;
    double score_ = 0.0;
    int object_ = -1, other_ = -1;
    std::string what_;
};

SnapIndex::SnapIndex(const std::vector<SceneObject>& objects) {
    for (const SceneObject& object : objects) {
        const int index = static_cast<int>(names_.size());
        names_.push_back({object.pointer, object.title, keyblock::hasCorners(object.kind), endsAtOpenings(object.kind)});
        if (object.kind == ObjectKind::Tunnel) openings_.push_back(object);
        for (const ObjectLine& line : object.lines) add(line, index);
        for (const Point& place : object.marks) marks_.push_back({place, index});
        for (const Point& place : object.middles) middles_.push_back({place, index});
    }
    if (!lines_.empty()) grid_.emplace(boxesOf(lines_));
}

void SnapIndex::add(const ObjectLine& line, int object) {
    const std::size_t count = line.points.size();
    const std::size_t segments = count < 2 ? 0 : line.closed ? count : count - 1;
    for (std::size_t i = 0; i < segments; ++i) {
        const bool inner = line.curved;
        lines_.push_back({line.points[i], line.points[(i + 1) % count], object, !inner || (i == 0 && !line.closed),
                          !inner || (i + 1 == segments && !line.closed), line.curved});
    }
}

std::vector<Box> SnapIndex::boxesOf(const std::vector<Line>& lines) {
    std::vector<Box> boxes;
    for (const Line& line : lines) boxes.push_back({line.a.cwiseMin(line.b), line.a.cwiseMax(line.b)});
    return boxes;
}

std::size_t SnapIndex::compared(const Point& place, double radius) const {
    return grid_ ? grid_->compared(grown(Box{place, place}, radius)) : 0;
}

std::optional<Snap> SnapIndex::at(const Point& place, const SnapWish& wish) const {
    if (!place.allFinite()) return std::nullopt;
    return Search(*this, place, wish).run();
}

}  // namespace keyblock
