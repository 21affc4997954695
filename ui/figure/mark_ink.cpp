// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/mark_ink.h"

namespace keyblock {

namespace {

using namespace paper_theme;

const Stroke casing{0.3, white};

std::vector<Point> rectangle(const Point& at, const Point& along, double half, double halfAcross) {
    const Point u = half * along, v = halfAcross * turnLeft(along);
    return {at - u - v, at + u - v, at + u + v, at - u + v};
}

void disc(Ink& ink, const Point& at, double radius) {
    ink.circle(at, radius + 0.12, white, {});
    ink.circle(at, radius, black, {});
}

void ring(Ink& ink, const Point& at, double radius, bool dashed) {
    ink.circle(at, radius + 0.1, white, {});
    ink.circle(at, radius, white,
               dashed ? Stroke{0.17, softText, {0.35, 0.25}} : Stroke{0.17, black});
}

void diamond(Ink& ink, const Point& at, double size) {
    ink.polygon({at + Point(0, -size), at + Point(size, 0), at + Point(0, size), at + Point(-size, 0)}, slipping,
                Stroke{0.17, black});
}

void cross(Ink& ink, const Point& at, double arm) {
    ink.circle(at, arm + 0.25, white, {});
    ink.line(at + Point(-arm, -arm), at + Point(arm, arm), {0.28, error});
    ink.line(at + Point(-arm, arm), at + Point(arm, -arm), {0.28, error});
}

/// Two chevrons that point apart along the bolt.
void chevrons(Ink& ink, const Point& at, const Point& along) {
    const Point across = turnLeft(along);
    ink.circle(at, 1.15, white, {});
    for (const double side : {-1.0, 1.0})
        ink.polyline({at + side * 0.35 * along + 0.8 * across, at + side * 1.0 * along,
                      at + side * 0.35 * along - 0.8 * across}, {0.28, error});
}

void plateLost(Ink& ink, const Point& at, const Point& along) {
    const Point middle = at + 0.9 * along;
    ink.polygon(rectangle(middle, along, 0.38, 1.15), white, Stroke{0.2, black});
    const Point strike = (0.6 * along + 1.3 * turnLeft(along));
    ink.line(middle - strike, middle + strike, {0.28, error});
}

}  // namespace

void drawMark(Ink& ink, MarkKind kind, const Point& at, const Point& along, bool small) {
    switch (kind) {
        case MarkKind::Bonded: return disc(ink, at, small ? 0.5 : 0.75);
        case MarkKind::Artificial: return ring(ink, at, small ? 0.38 : 0.5, false);
        case MarkKind::InGap: return ring(ink, at, small ? 0.38 : 0.5, true);
        case MarkKind::Slipping: return diamond(ink, at, small ? 0.75 : 1.0);
        case MarkKind::Gone: return cross(ink, at, small ? 0.5 : 0.65);
        case MarkKind::Yielded:
            return ink.polygon(rectangle(at, {1.0, 0.0}, 0.6, 0.6), yielded, casing);
        case MarkKind::Ruptured: return chevrons(ink, at, along);
        case MarkKind::Plate: return ink.polygon(rectangle(at, along, 0.4, 1.2), black, casing);
        case MarkKind::PlateLost: return plateLost(ink, at, along);
    }
}

std::string nameOf(MarkKind kind) {
    switch (kind) {
        case MarkKind::Bonded: return "real, bonded";
        case MarkKind::Artificial: return "artificial";
        case MarkKind::InGap: return "in a gap";
        case MarkKind::Slipping: return "slipping";
        case MarkKind::Gone: return "gone";
        case MarkKind::Yielded: return "steel yielded";
        case MarkKind::Ruptured: return "ruptured";
        case MarkKind::Plate: return "face plate";
        case MarkKind::PlateLost: return "plate lost";
    }
    return {};
}

void drawNumber(Ink& ink, const Point& at, int number, double radius, const TextStyle& style) {
    ink.circle(at, radius, white, Stroke{0.17, black});
    ink.text(at + Point(0.0, 0.36 * style.size), std::to_string(number), style, Align::Centre);
}

}  // namespace keyblock
