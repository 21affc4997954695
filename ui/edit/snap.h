// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The snap point near the mouse. The nearest candidate is often not the intended
// one: an end a few pixels away takes precedence over a line just under the mouse.
// Candidates are ranked by kind, and by distance among similar kinds.
#pragma once

#include "geometry/grid.h"
#include "ui/edit/scene_objects.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

enum class SnapKind { End, Intersection, Middle, Foot, OnLine, Grid };

struct Snap {
    Point place{0.0, 0.0};  // [m]
    SnapKind kind = SnapKind::Grid;
    std::string name;  // shown to the user: `end of joint J12`
    std::string pointer;  // of the object; empty: the grid
};

/// The options of a snap.
struct SnapWish {
    double radius = 0.0;  // largest distance from the mouse [m]
    bool objects = true;
    std::optional<double> grid{};  // spacing [m]; the grid snaps at any distance
    std::optional<Point> previous{};  // the last point drawn, the base of perpendiculars
    std::vector<std::string> except{};  // pointers of objects being drawn or dragged, left out
};

/// The lines of a scene, indexed for many queries.
class SnapIndex {
public:
    explicit SnapIndex(const std::vector<SceneObject>& objects);

    /// The best snap near `place`; none if nothing is near and there is no grid.
    std::optional<Snap> at(const Point& place, const SnapWish& wish) const;

    /// The number of lines that `at` compares with the mouse.
    std::size_t compared(const Point& place, double radius) const;

private:
    struct Line {
        Point a{0.0, 0.0}, b{0.0, 0.0};
        int object = 0;
        bool endA = false, endB = false;  // an end or a corner, not a point of an arc
        bool curved = false;
    };
    struct Mark {
        Point place{0.0, 0.0};
        int object = 0;
    };
    struct Name {
        std::string pointer, title;
        bool hasCorners = false, inRock = false;  // inRock: not visible in openings
    };
    class Search;

    void add(const ObjectLine& line, int object);
    static std::vector<Box> boxesOf(const std::vector<Line>& lines);

    std::vector<Name> names_;
    std::vector<Line> lines_;
    std::vector<Mark> marks_, middles_;
    std::vector<SceneObject> openings_;
    std::optional<BoxGrid> grid_;
};

}  // namespace keyblock
