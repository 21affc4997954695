// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/problem_remedies.h"

#include "geometry/polygon.h"
#include "solver/scene/field.h"
#include "ui/edit/edits.h"
#include "ui/edit/locate.h"
#include "ui/panels/field_choices.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Remedies)
};

/// Lists to which a missing name can be added directly.
std::string listNamed(std::string_view key) {
    if (key == "material") return "/materials";
    if (key == "joint_material") return "/joint_materials";
    return {};
}

std::optional<Remedy> addWhatIsNamed(const Scene& scene, const ScenePlace& place) {
    const std::string list = listNamed(place.field->key);
    if (list.empty() || !place.field->get) return std::nullopt;
    const FieldValue value = place.field->get(place.owner);
    const auto* name = std::get_if<std::string>(&value);
    const auto names = choicesOf(scene, *place.structure, *place.field);
    if (!name || name->empty() || !names || std::ranges::count(*names, *name)) return std::nullopt;
    return Remedy{Texts::tr("Add %1").arg(QString::fromStdString(*name)),
                  [list, wanted = *name](const Scene& now) { return appendAt(now, list, wanted); }};
}

std::optional<Remedy> renameTaken(const Problem& problem, const ScenePlace& place) {
    const bool taken = problem.message.find("is already used by an earlier") != std::string::npos;
    if (!taken || place.field->key != "name") return std::nullopt;
    const std::string object = parentOf(problem.pointer);
    return Remedy{Texts::tr("Rename it"), [object](const Scene& now) {
                      return renameAt(now, object, nameOfCopy(now, parentOf(object), nameAt(now, object)));
                  }};
}

/// Fields and corners that the check suggests to omit.
std::optional<Remedy> leaveOut(const Problem& problem, const ScenePlace& place) {
    const std::string pointer = problem.pointer;
    if (problem.remedy.starts_with("Omit it")) {
        if (place.element)
            return Remedy{Texts::tr("Omit it"), [pointer](const Scene& now) { return removeAt(now, pointer); }};
        return Remedy{Texts::tr("Omit it"), [pointer](const Scene& now) { return resetAt(now, pointer); }};
    }
    if (problem.remedy.ends_with("omit it to let the program choose") && place.field->nullable)
        return Remedy{Texts::tr("Set automatically"),
            [pointer](const Scene& now) { return setNullAt(now, pointer); }};
    return std::nullopt;
}

std::optional<Remedy> takePlateOff(const Problem& problem) {
    if (problem.remedy.find("\"plate\": \"none\"") == std::string::npos) return std::nullopt;
    std::string object = problem.pointer;
    if (object.ends_with("/head")) object = parentOf(object);
    return Remedy{Texts::tr("Remove the plate"), [plate = object + "/plate"](const Scene& now) {
                      return setValueAt(now, plate, std::string("none"));
                  }};
}

double perimeterOf(const std::vector<Point>& points) {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += (points[(i + 1) % points.size()] - points[i]).norm();
    return sum;
}

}  // namespace

std::optional<Remedy> remedyFor(const Scene& scene, const Problem& problem) {
    if (problem.pointer.empty() && scene.stages.empty() && problem.message.find("no stages") != std::string::npos)
        return Remedy{Texts::tr("Add a stage"), [](const Scene& now) { return appendAt(now, "/stages"); }};
    const auto place = locate(scene, problem.pointer);
    if (!place || !place->field) return std::nullopt;
    for (auto remedy : {addWhatIsNamed(scene, *place), renameTaken(problem, *place), leaveOut(problem, *place),
                        takePlateOff(problem)})
        if (remedy) return remedy;
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
        if (block.faces.empty()) continue;  // given as it is, not cut
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
        slivers.count == 1 ? Texts::tr("Merge the sliver") : Texts::tr("Merge %1 slivers").arg(slivers.count);
    return {text, [](const Scene& now) {
                Edit edit = setNullAt(now, "/cutting/min_area");
                return edit.done() ? setNullAt(edit.scene, "/cutting/min_width") : edit;
            }};
}

}  // namespace keyblock
