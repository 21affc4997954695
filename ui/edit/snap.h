// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the snap point near the mouse. The nearest candidate is often not the intended
// one: an end a few pixels away is preferred to a line directly under the mouse.
// Candidates are therefore ranked by kind, and by distance among similar kinds.
#pragma once

#include "geometry/grid.h"
#include "ui/edit/scene_objects.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Kinds of snap points: end or corner, intersection, midpoint or centre, foot of a perpendicular, nearest point on a
/// line, grid point.
enum class SnapKind { End, Intersection, Middle, Foot, OnLine, Grid };

struct Snap {
    Point place{0.0, 0.0};  // [m]
    SnapKind kind = SnapKind::Grid;
    std::string name;  // shown to the user: `end of joint J12`
    std::string pointer;  // JSON pointer of the object; empty: a grid point
};

/// Options of a search for a snap point.
struct SnapWish {
    double radius = 0.0;  // largest distance from the mouse [m]
    bool objects = true;  // snap to objects
    std::optional<double> grid{};  // grid spacing [m]; used at any distance if no object is near
    std::optional<Point> previous{};  // last point drawn [m], from which perpendiculars start
    std::vector<std::string> except{};  // JSON pointers of objects to ignore, such as the one being dragged
};

/// Spatial index of the lines of a scene, for many queries.
class SnapIndex {
public:
    explicit SnapIndex(const std::vector<SceneObject>& objects);

    /// The best snap point near `place`; null if nothing is near and there is no grid.
    std::optional<Snap> at(const Point& place, const SnapWish& wish) const;

    /// Number of lines that `at` examines for this position and search radius [m].
    std::size_t compared(const Point& place, double radius) const;

private:
    struct Line {
        Point a{0.0, 0.0}, b{0.0, 0.0};
        int object = 0;
        bool endA = false, endB = false;  // an end or a corner, not an inner point of an arc
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
