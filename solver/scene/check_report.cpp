// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small checks that several parts of the scene check share.
#include "solver/scene/check_report.h"

#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <unordered_map>

namespace keyblock {

namespace {

std::string placeText(const Point& place) { return "(" + coordinateText(place.x()) + ", " + coordinateText(place.y()) + ")"; }

/// Whether a new entry of this list needs only a name; entries of all other lists need a position in the section.
bool canBeAdded(std::string_view list) { return list == "materials" || list == "joint_materials"; }

/// Repair that renames the object with this name. There is none for an entry of a map: both entries have the same
/// pointer and have to be renamed by hand.
Repair renaming(const std::string& pointer) {
    constexpr std::string_view key = "/name";
    const bool isField = pointer.ends_with(key) && std::count(pointer.begin(), pointer.end(), '/') > 2;
    return isField ? Repair{RepairKind::Rename, pointer.substr(0, pointer.size() - key.size())} : Repair{};
}

}  // namespace

void CheckReport::error(std::string pointer, std::string message, std::string remedy, Repair repair) {
    addProblem(problems, {Severity::Error, "", 0, std::move(pointer), std::move(message), std::move(remedy),
                          std::move(repair)});
}

void CheckReport::warning(std::string pointer, std::string message, std::string remedy, Repair repair) {
    addProblem(problems, {Severity::Warning, "", 0, std::move(pointer), std::move(message), std::move(remedy),
                          std::move(repair)});
}

void CheckReport::note(std::string pointer, std::string message, std::string remedy) {
    addProblem(problems, {Severity::Note, "", 0, std::move(pointer), std::move(message), std::move(remedy)});
}

bool CheckContext::allSound() const {
    return isCut && !sound.empty() && std::all_of(sound.begin(), sound.end(), [](bool isSound) { return isSound; });
}

int checkBlockAt(CheckContext& context, const Point& place, const std::string& pointer) {
    if (!place.allFinite())
        return -1;
    const int block = blockAt(context.scene, place, context.tolerance);
    // A point in a block with errors is not reported a second time.
    if (block >= 0 || !context.allSound())
        return block;
    if (blockWithPoint(context.scene, place) >= 0)
        context.report.error(pointer, placeText(place) + " lies on the boundary of a block",
                             "Give a point inside the block");
    else
        context.report.error(pointer, placeText(place) + " is not in any block",
                             "Give a point inside the block");
    return -1;
}

int checkPointOnBlock(CheckContext& context, const Point& point, const std::string& pointer) {
    if (!point.allFinite())
        return -1;
    const int block = blockWithPoint(context.scene, point);
    if (block < 0 && context.allSound())
        context.report.error(pointer, placeText(point) + " is not in any block",
                             "Give a point inside a block or on its boundary");
    return block;
}

void checkReference(const std::string& name, const std::vector<std::string_view>& names, std::string_view list,
                    const std::string& pointer, CheckReport& report) {
    if (!name.empty() && !report.isFull() && std::find(names.begin(), names.end(), name) == names.end())
        report.error(pointer, inQuotes(name) + " is not among the " + inQuotes(list), suggestion(name, names),
                     canBeAdded(list) ? Repair{RepairKind::AddNamed, under("", list), name} : Repair{});
}

void checkAxis(const Point& axis, const std::string& pointer, CheckReport& report) {
    if (axis.allFinite() && axis.norm() == 0.0)
        report.error(pointer, "the axis has no direction", "Write \"x\", \"y\" or a vector that is not zero");
}

void checkNamesDiffer(std::size_t count, const std::function<std::string(std::size_t)>& nameOf,
                      const std::function<std::string(std::size_t)>& pointerOf, std::string_view what,
                      CheckReport& report) {
    std::unordered_map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string name = nameOf(i);
        if (name.empty())
            continue;
        const auto [found, isNew] = first.try_emplace(name, i);
        if (!isNew)
            report.error(pointerOf(i),
                         "the name " + inQuotes(name) + " is already used by an earlier " + std::string(what) + " (" +
                             pointerOf(found->second) + ")",
                         "Give each " + std::string(what) + " its own name", renaming(pointerOf(i)));
    }
}

}  // namespace keyblock
