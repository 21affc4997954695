// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/mark_painter.h"

#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

std::vector<Point> rectangle(const Point& at, const Point& along, double half, double halfAcross) {
    const Point u = half * along, v = halfAcross * turnLeft(along);
    return {at - u - v, at + u - v, at + u + v, at - u + v};
}

/// Draws one mark at its position.
class MarkPainter {
public:
    MarkPainter(Ink& ink, const MarkTheme& theme, const Point& at, bool small)
        : ink_(ink), colours_(theme.colours), sizes_(theme.sizes), at_(at), small_(small) {}

    void disc() {
        const double radius = sizes_.disc.of(small_);
        ink_.circle(at_, radius + sizes_.casing, colours_.casing, {});
        ink_.circle(at_, radius, colours_.ink, {});
    }

    void ring(bool dashed) {
        const double radius = sizes_.ring.of(small_);
        ink_.circle(at_, radius + 0.8 * sizes_.casing, colours_.casing, {});
        const Stroke whole{sizes_.line, colours_.ink}, parts{sizes_.line, colours_.soft, {sizes_.dash, sizes_.gap}};
        ink_.circle(at_, radius, colours_.hollow, dashed ? parts : whole);
    }

    void diamond() {
        const double size = sizes_.diamond.of(small_);
        ink_.polygon({at_ + Point(0, -size), at_ + Point(size, 0), at_ + Point(0, size), at_ + Point(-size, 0)},
                     colours_.slipping, Stroke{sizes_.line, colours_.rim});
    }

    void cross() {
        const double arm = sizes_.cross.of(small_);
        ink_.circle(at_, arm + 2.0 * sizes_.casing, colours_.casing, {});
        for (const double side : {-1.0, 1.0})
            ink_.line(at_ + Point(-arm, -side * arm), at_ + Point(arm, side * arm), {sizes_.stroke, colours_.error});
    }

    void square() {
        cased(rectangle(at_, {1.0, 0.0}, sizes_.square, sizes_.square), colours_.yielded);
    }

    /// Draws two chevrons that point apart along the bolt.
    void chevrons(const Point& along) {
        const Point across = sizes_.chevronAcross * turnLeft(along);
        ink_.circle(at_, sizes_.chevronTo + sizes_.casing, colours_.casing, {});
        for (const double side : {-1.0, 1.0})
            ink_.polyline({at_ + side * sizes_.chevronFrom * along + across, at_ + side * sizes_.chevronTo * along,
                           at_ + side * sizes_.chevronFrom * along - across}, {sizes_.stroke, colours_.error});
    }

    void plate(const Point& along) {
        cased(rectangle(at_, along, sizes_.plateAlong, sizes_.plateAcross), colours_.ink);
    }

    void plateLost(const Point& along) {
        const Point middle = at_ + sizes_.lostAway * along;
        const Point tilted = std::cos(sizes_.lostTilt) * along + std::sin(sizes_.lostTilt) * turnLeft(along);
        const auto corners = rectangle(middle, tilted, sizes_.lostAlong, sizes_.lostAcross);
        ink_.polygon(corners, colours_.casing, Stroke{1.6 * sizes_.casing, colours_.casing});
        ink_.polygon(corners, colours_.hollow, Stroke{0.7 * sizes_.stroke, colours_.ink});
        const Point strike = 1.6 * sizes_.lostAlong * tilted + 1.13 * sizes_.lostAcross * turnLeft(tilted);
        ink_.line(middle - strike, middle + strike, {sizes_.stroke, colours_.error});
    }

private:
    void cased(const std::vector<Point>& corners, const Colour& fill) {
        ink_.polygon(corners, colours_.casing, Stroke{2.0 * sizes_.casing, colours_.casing});
        ink_.polygon(corners, fill, {});
    }

    Ink& ink_;
    const MarkColours& colours_;
    const MarkSizes& sizes_;
    Point at_;
    bool small_;
};

}  // namespace

void drawMark(Ink& ink, MarkKind kind, const Point& at, const Point& along, bool small, const MarkTheme& theme) {
    MarkPainter mark(ink, theme, at, small);
    switch (kind) {
        case MarkKind::Bonded: return mark.disc();
        case MarkKind::Artificial: return mark.ring(false);
        case MarkKind::InGap: return mark.ring(true);
        case MarkKind::Slipping: return mark.diamond();
        case MarkKind::Gone: return mark.cross();
        case MarkKind::Yielded: return mark.square();
        case MarkKind::Ruptured: return mark.chevrons(along);
        case MarkKind::Plate: return mark.plate(along);
        case MarkKind::PlateLost: return mark.plateLost(along);
    }
}

std::string nameOf(MarkKind kind) {
    switch (kind) {
        case MarkKind::Bonded: return "bonded";
        case MarkKind::Artificial: return "intermediate";
        case MarkKind::InGap: return "in a gap";
        case MarkKind::Slipping: return "slipping";
        case MarkKind::Gone: return "failed";
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
