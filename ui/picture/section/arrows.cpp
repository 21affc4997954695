// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/arrows.h"

#include "solver/results/frame_quantities.h"
#include "solver/scene/units.h"
#include "ui/picture/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 3> arrowKinds{"stress-crosses", "displacement-arrows", "velocity-arrows"};

constexpr double longestArrow = 9.0;  // [mm]
constexpr double smallestArrow = 1e-100;  // values below this have no scale
constexpr double megapascals = perSi(namedUnit("MPa")), millimetres = perSi(namedUnit("mm"));

void addBar(ArrowField& field, const Point& place, const Point& along, double compression) {
    field.marks.push_back({compression >= 0.0 ? ArrowShape::Compression : ArrowShape::Tension, place,
                           std::abs(compression) * along});
}

void addCross(ArrowField& field, const BlockState& block, const Point& place) {
    const PrincipalStress stress = principalStress(block.stress);
    addBar(field, place, stress.direction, stress.major * megapascals);
    addBar(field, place, turnLeft(stress.direction), stress.minor * megapascals);
}

}  // namespace

std::optional<ArrowKind> arrowKindOf(std::string_view word) {
    const auto found = std::find(arrowKinds.begin(), arrowKinds.end(), word);
    if (found == arrowKinds.end()) return std::nullopt;
    return static_cast<ArrowKind>(found - arrowKinds.begin());
}

std::span<const std::string_view> arrowWords() { return arrowKinds; }

double arrowScale(const ArrowField& field) { return field.largest > 0.0 ? longestArrow / field.largest : 0.0; }

ArrowField arrowField(ArrowKind kind, const Frame& frame, const std::vector<Point>& places) {
    ArrowField field;
    switch (kind) {
        case ArrowKind::StressCrosses:
            field = {"Principal stresses", "MPa", {"black compression, red tension"}, {}, 0.0};
            break;
        case ArrowKind::Displacements: field = {"Displacement", "mm", {}, {}, 0.0}; break;
        case ArrowKind::Velocities: field = {"Velocity", "m/s", {}, {}, 0.0}; break;
    }
    for (std::size_t b = 0; b < frame.blocks.size(); ++b) {
        const BlockState& block = frame.blocks[b];
        if (block.area == 0.0) continue;
        if (kind == ArrowKind::StressCrosses) addCross(field, block, places[b]);
        if (kind == ArrowKind::Displacements)
            field.marks.push_back({ArrowShape::Arrow, places[b], block.displacement * millimetres});
        if (kind == ArrowKind::Velocities) field.marks.push_back({ArrowShape::Arrow, places[b], block.velocity});
    }
    std::erase_if(field.marks, [](const ArrowMark& mark) {
        return !canBeShown(mark.value.norm()) || !canBeShown(mark.place.norm());
    });
    for (const ArrowMark& mark : field.marks) field.largest = std::max(field.largest, mark.value.norm());
    if (field.largest < smallestArrow) field.largest = 0.0;
    return field;
}

}  // namespace keyblock
