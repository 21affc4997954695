// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the parts of the check share: where they put what they find, and what
// they already know of the scene.
#pragma once

#include "solver/scene/field.h"
#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// A block is cut into at most so many cells.
inline constexpr double mostCells = 1e6;

/// Collects problems.
struct CheckReport {
    std::vector<Problem> problems;

    void error(std::string pointer, std::string message, std::string remedy, Repair repair = {});
    void warning(std::string pointer, std::string message, std::string remedy, Repair repair = {});
    void note(std::string pointer, std::string message, std::string remedy);
};

/// A scene on the way through its check.
struct CheckContext {
    const Scene& scene;
    double tolerance = 0.0;  // geometric [m]
    std::vector<bool> sound;  // per block: an outline that places can be looked up in
    std::vector<bool> fixed;  // per block: held as a whole
    const Scene& document;  // as it was given, before the cut
    bool isCut = true;  // false where something kept the domain from being cut, so that not all blocks are there
    CheckReport& report;

    bool allSound() const;  // false without blocks: then nothing can be looked up either
};

/// Numbers finite and in range, required texts not empty, fields where they belong; below `object`, by the table.
void checkFields(const Structure& structure, const void* object, const std::string& pointer, CheckReport& report);

/// One value against its row: finite, in range.
void checkValue(const Field& field, const FieldValue& value, const std::string& pointer, CheckReport& report);

/// What is to be cut, and the patterns of bolts: all that must hold before `cutScene`. \pre `context.scene` is the
/// document.
void checkSection(CheckContext& context);

/// No bolt, given or laid out by a pattern, has the name of a pattern.
void checkBoltNames(CheckContext& context);

/// Outline of a block, a domain or a region: corners enough, none twice, an area, no crossing. False when not.
/// \param what for people, e.g. `the block`
bool checkOutline(const std::vector<Point>& points, const std::string& pointer, std::string_view what,
                  double tolerance, CheckReport& report);

/// Reports that `name` is not among `names`, those in the scene's `list`; an empty one is reported elsewhere.
void checkReference(const std::string& name, const std::vector<std::string_view>& names, std::string_view list,
                    const std::string& pointer, CheckReport& report);

/// Names of the entries of a map, or of a list of things with names.
template <typename Item>
std::vector<std::string_view> namesOf(const std::vector<Item>& items) {
    std::vector<std::string_view> names;
    for (const Item& item : items)
        if constexpr (requires { item.first; })
            names.push_back(item.first);
        else
            names.push_back(item.name);
    return names;
}

void checkRock(CheckContext& context);  // blocks, materials, supports; fills `sound` and `fixed`
void checkBodies(CheckContext& context);  // cells and plates that are blocks; after rock and bolts
void checkBoltTypes(CheckContext& context);
void checkBolts(CheckContext& context);
void checkStages(CheckContext& context);
void checkAccelerations(const Stage& stage, const std::string& pointer, CheckContext& context);
void checkLengthOfRecords(CheckContext& context);
void checkStrengthChanges(const Stage& stage, const std::string& pointer, CheckContext& context);
void checkActivation(CheckContext& context);  // names that stages excavate, install and remove
void checkWatch(CheckContext& context);  // monitors, quantities, expected numbers

/// True where the bolt runs through a block that is not `gone`; empty: none is.
bool runsThroughRock(const Bolt& bolt, const CheckContext& context, const std::vector<bool>& gone);

/// Anchors of a type or a bolt, without their place on a bolt.
void checkAnchors(const std::vector<Anchor>& anchors, const std::string& pointer, CheckReport& report);

/// Reports a block that has been excavated at the start of a stage; ignores −1.
void checkStands(int block, std::size_t stage, const std::string& pointer, CheckContext& context);

/// Finds the block for a `block_at`, or reports that there is none and gives −1.
int checkBlockAt(CheckContext& context, const Point& place, const std::string& pointer);

/// Finds the block that holds a point inside or on its boundary, or reports that there is none and gives −1.
int checkPointOnBlock(CheckContext& context, const Point& point, const std::string& pointer);

/// A direction must have a length.
void checkAxis(const Point& axis, const std::string& pointer, CheckReport& report);

/// Reports every name that occurred before; empty names are left alone.
void checkNamesDiffer(std::size_t count, const std::function<std::string(std::size_t)>& nameOf,
                      const std::function<std::string(std::size_t)>& pointerOf, std::string_view what,
                      CheckReport& report);

}  // namespace keyblock
