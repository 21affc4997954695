// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/force_shapes.h"

#include "ui/view/screen_sizes.h"

#include <algorithm>

namespace keyblock {

namespace {

constexpr double arrowWidth = 1.3, rim = 1.2, shortest = 1.5, longestTip = 5.0;  // [px]
constexpr double contactOpen = 0.3;  // gap in the line of a contact in tension, relative to its length

class ForceBuilder {
public:
    ForceBuilder(const Point& origin, double scale, const ViewColours& colours)
        : origin_(origin), scale_(scale), colours_(colours) {}

    /// Adds an arrow. `value` is its vector in pixels, with y upwards.
    void addArrow(const ArrowMark& mark, const Point& value) {
        const double size = value.norm();
        if (size < shortest) return;
        const Point way = value / scale_;
        if (mark.shape != ArrowShape::Arrow) {
            const Colour& colour = mark.shape == ArrowShape::Tension ? colours_.error : colours_.ink;
            return add(shapes_.lines, mark.place - 0.5 * way, mark.place + 0.5 * way, arrowWidth, colour);
        }
        const Point tip = mark.place + way, along = value / size;
        const double head = std::min(longestTip, 0.4 * size) / scale_;
        add(shapes_.lines, mark.place, tip, arrowWidth, colours_.ink);
        for (const double side : {-0.45, 0.45})
            add(shapes_.lines, tip, tip - head * along + side * head * turnLeft(along), arrowWidth, colours_.ink);
    }

    /// Adds the line of a contact. `length` and `width` are in pixels.
    void addContact(const ContactLine& line, double length, double width) {
        const Point half = 0.5 * length / scale_ / line.force.norm() * line.force, &at = line.place;
        const double dot = 1e-3 / scale_;
        switch (line.kind) {
            case ContactKind::Locked: return add(shapes_.lines, at - half, at + half, width, colours_.bearing);
            case ContactKind::Sliding:
                add(shapes_.rims, at - half, at + half, width + rim, colours_.ink);
                return add(shapes_.lines, at - half, at + half, width, colours_.slipping);
            case ContactKind::Bonded:
                add(shapes_.lines, at - half, at + half, width, colours_.bearing);
                return add(shapes_.lines, at, at + Point(dot, 0.0), width + 2.0, colours_.bearing);
            case ContactKind::Pulled:
                add(shapes_.lines, at - half, at - contactOpen * half, width, colours_.error);
                return add(shapes_.lines, at + contactOpen * half, at + half, width, colours_.error);
        }
    }

    ForceShapes take() { return std::move(shapes_); }

private:
    void add(LayerShapes& to, const Point& from, const Point& until, double width, const Colour& colour) const {
        for (const Point& place : {from, until}) {
            to.cells.push_back(static_cast<int>(to.corners.size() / 2));
            to.corners.push_back(static_cast<float>(place.x() - origin_.x()));
            to.corners.push_back(static_cast<float>(place.y() - origin_.y()));
            to.colours.insert(to.colours.end(), {colour.red, colour.green, colour.blue});
        }
        to.widths.push_back(static_cast<float>(width));
    }

    Point origin_;
    double scale_;
    const ViewColours& colours_;
    ForceShapes shapes_;
};

}  // namespace

ForceShapes forceShapes(const SectionPicture& picture, const Point& origin, double scale, const ViewColours& colours,
                        const Box& window) {
    ForceBuilder builder(origin, scale, colours);
    if (picture.arrows)
        for (const ArrowMark& mark : picture.arrows->marks)
            builder.addArrow(mark, arrowScale(*picture.arrows) * pixelsPerMm * mark.value);
    if (picture.contacts) {
        const ContactScale& sizes = picture.contacts->scale;
        const double longest = longestContactLine(sizes.spacing * scale / pixelsPerMm);
        for (const ContactLine& line : seenWithin(*picture.contacts, window).lines)
            builder.addContact(line, pixelsPerMm * contactLength(sizes, line.force.norm(), longest),
                               pixelsPerMm * contactWidth(sizes, line.force.norm(), longest));
    }
    return builder.take();
}

}  // namespace keyblock
