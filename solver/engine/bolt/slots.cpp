// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/slots.h"

#include "geometry/polygon.h"
#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// Fractions of the bolt's length at which it meets edges of the cells and may pass from one cell to the next.
std::vector<double> crossingsOfCells(const Model& model, const std::vector<int>& cells, const Point& farEnd,
                                     const Point& head) {
    const double length = (head - farEnd).norm();
    const Point axis = (head - farEnd) / length;
    std::vector<double> places{0.0, 1.0};
    for (int cell : cells) {
        const std::vector<Point> corners = startCorners(model.blocks[cell]);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point p = corners[i] - farEnd, q = corners[(i + 1) % corners.size()] - farEnd;
            const double offP = cross(axis, p), offQ = cross(axis, q);
            if (std::abs(offP) <= model.tolerance) places.push_back(axis.dot(p) / length);
            else if (std::abs(offQ) > model.tolerance && offP * offQ < 0.0)
                places.push_back(axis.dot(p + offP / (offP - offQ) * (q - p)) / length);
        }
    }
    std::erase_if(places, [](double s) { return s < 0.0 || s > 1.0; });
    std::sort(places.begin(), places.end());
    return places;
}

/// The first cell that contains the point, otherwise the first of several cells that touch it; −1 on an outer face.
int cellAt(const Model& model, const std::vector<int>& cells, const Point& place) {
    int between = -1, touching = 0;
    for (int cell : cells) {
        const Side side = locate(startCorners(model.blocks[cell]), place, model.tolerance);
        if (side == Side::Inside) return cell;
        if (side == Side::Outside) continue;
        if (touching++ == 0) between = cell;
    }
    return touching > 1 ? between : -1;
}

void addSlot(const Model& model, int block, double from, double to, const Point& farEnd, const Point& head,
             std::vector<Slot>& slots) {
    const double length = (head - farEnd).norm();
    const Point p2 = farEnd + from * (head - farEnd), p3 = farEnd + to * (head - farEnd);
    const Point& centroid = model.blocks[block].centroid;
    slots.push_back({block, p2 - centroid, p3 - centroid, from * length, to * length});
}

void addCellSlots(const Model& model, int first, int end, const Point& farEnd, const Point& head,
                  std::vector<Slot>& slots) {
    const Box way = grown(boxOf(std::vector<Point>{farEnd, head}), model.tolerance);
    std::vector<int> cells;
    for (int cell = first; cell < end; ++cell)
        if (meets(boxOf(startCorners(model.blocks[cell])), way)) cells.push_back(cell);
    const std::vector<double> places = crossingsOfCells(model, cells, farEnd, head);
    const double least = model.tolerance / (head - farEnd).norm();
    int open = -1;
    double from = 0.0, to = 0.0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        if (places[i + 1] - places[i] <= least) continue;
        const int cell = cellAt(model, cells, farEnd + 0.5 * (places[i] + places[i + 1]) * (head - farEnd));
        if (cell != open && open >= 0) addSlot(model, open, from, to, farEnd, head, slots);
        if (cell != open) from = places[i];
        to = places[i + 1];
        open = cell;
    }
    if (open >= 0) addSlot(model, open, from, to, farEnd, head, slots);
}

}  // namespace

std::vector<Slot> slotsAlong(const Model& model, const Point& farEnd, const Point& head) {
    std::vector<Slot> slots;
    for (std::size_t rock = 0; rock + 1 < model.firstOf.size(); ++rock) {
        const int first = model.firstOf[rock];
        if (model.blocks[first].cell) {
            addCellSlots(model, first, model.firstOf[rock + 1], farEnd, head, slots);
            continue;
        }
        for (const auto& [from, to] :
             insideIntervals(startCorners(model.blocks[first]), farEnd, head, model.tolerance))
            addSlot(model, first, from, to, farEnd, head, slots);
    }
    std::sort(slots.begin(), slots.end(), [](const Slot& a, const Slot& b) { return a.s2 < b.s2; });
    return slots;
}

std::vector<double> jointPlaces(const Model& model, const std::vector<Slot>& slots, double length) {
    const auto goesOn = [&](const Slot& slot, double s) {  // the bolt continues in the next cell of the same block
        return model.blocks[slot.block].cell && std::any_of(slots.begin(), slots.end(), [&](const Slot& other) {
            return other.block != slot.block && sameRock(model, other.block, slot.block) &&
                   std::min(std::abs(other.s2 - s), std::abs(other.s3 - s)) <= 2.0 * model.tolerance;
        });
    };
    std::vector<double> places;
    for (const Slot& slot : slots)
        for (double s : {slot.s2, slot.s3})
            if (s > model.tolerance && s < length - model.tolerance && !goesOn(slot, s)) places.push_back(s);
    std::sort(places.begin(), places.end());
    const auto close = [&](double a, double b) { return b - a <= model.tolerance; };
    places.erase(std::unique(places.begin(), places.end(), close), places.end());
    return places;
}

int startBlockOf(const Model& model, const std::vector<Slot>& slots, double s) {
    int block = -1, touching = 0;
    for (const Slot& slot : slots) {
        if (s < slot.s2 - model.tolerance || s > slot.s3 + model.tolerance) continue;
        if (block >= 0 && block != slot.block && sameRock(model, block, slot.block)) continue;
        block = slot.block;
        ++touching;
    }
    return touching == 1 ? block : -1;
}

}  // namespace keyblock
