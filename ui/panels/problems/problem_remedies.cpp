// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/problems/problem_remedies.h"

#include "geometry/polygon.h"
#include "ui/edit/edits.h"
#include "ui/edit/locate.h"

#include <QCoreApplication>

#include <cmath>

namespace keyblock {

namespace {

struct RemedyTexts {
    Q_DECLARE_TR_FUNCTIONS(Remedies)
};

/// The only list elements with this repair are repeated corners of outlines.
std::optional<Remedy> omit(const Scene& scene, const std::string& pointer) {
    const auto place = locate(scene, pointer);
    if (!place || !place->field) return std::nullopt;
    if (place->element)
        return Remedy{RemedyTexts::tr("Remove the corner"),
                      [pointer](const Scene& now) { return removeAt(now, pointer); }};
    return Remedy{RemedyTexts::tr("Reset to default"), [pointer](const Scene& now) { return resetAt(now, pointer); }};
}

double perimeterOf(const std::vector<Point>& points) {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += (points[(i + 1) % points.size()] - points[i]).norm();
    return sum;
}

}  // namespace

std::optional<Remedy> remedyFor(const Scene& scene, const Problem& problem) {
    const std::string& pointer = problem.repair.pointer;
    switch (problem.repair.kind) {
        case RepairKind::None: break;
        case RepairKind::Omit: return omit(scene, pointer);
        case RepairKind::AddNamed:
            return Remedy{RemedyTexts::tr("Add %1").arg(QString::fromStdString(problem.repair.name)),
                          [pointer, name = problem.repair.name](const Scene& now) {
                              return appendAt(now, pointer, name);
                          }};
        case RepairKind::AddStage:
            return Remedy{RemedyTexts::tr("Add a stage"), [pointer](const Scene& now) { return appendAt(now, pointer); }};
        case RepairKind::Rename:
            return Remedy{RemedyTexts::tr("Assign a new name"), [pointer](const Scene& now) {
                              return renameAt(now, pointer, nameOfCopy(now, parentOf(pointer), nameAt(now, pointer)));
                          }};
        case RepairKind::SetAutomatic:
            return Remedy{RemedyTexts::tr("Use automatic value"),
                          [pointer](const Scene& now) { return setNullAt(now, pointer); }};
        case RepairKind::RemovePlate:
            return Remedy{RemedyTexts::tr("Remove the plate"),
                          [pointer](const Scene& now) { return setValueAt(now, pointer, std::string("none")); }};
    }
    return std::nullopt;
}

Slivers sliversOf(const Scene& scene, const SceneCut& cut) {
    Slivers slivers;
    if ((!scene.cutting.minArea && !scene.cutting.minWidth) || cut.blocks == 0) return slivers;
    const double mean = cut.area / cut.blocks;
    const double leastArea = 1e-3 * mean;
    slivers.width = 1e-2 * std::sqrt(mean);
    std::vector<Point> corners;
    for (const Block& block : cut.scene.blocks) {
        if (block.faces.empty()) continue;  // given in the scene, not made by cutting
        const double area = std::abs(signedArea(block.points));
        if (area >= leastArea && 2.0 * area / perimeterOf(block.points) >= slivers.width) continue;
        ++slivers.count;
        slivers.area += area;
        corners.insert(corners.end(), block.points.begin(), block.points.end());
    }
    if (!corners.empty()) slivers.box = boxOf(corners);
    return slivers;
}

Remedy mergeSlivers(const Slivers& slivers) {
    const QString text =
        slivers.count == 1 ? RemedyTexts::tr("Merge the sliver") : RemedyTexts::tr("Merge %1 slivers").arg(slivers.count);
    return {text, [](const Scene& now) {
                Edit edit = setNullAt(now, "/cutting/min_area");
                return edit.done() ? setNullAt(edit.scene, "/cutting/min_width") : edit;
            }};
}

}  // namespace keyblock
