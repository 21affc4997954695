// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shared by the parts of the scene check: the report that collects their problems,
// the results of earlier parts, and common checks.
#pragma once

#include "solver/scene/field.h"
#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Maximum number of cells of one block.
inline constexpr double mostCells = 1e6;

/// Maximum number of corners of one outline: checks of two neighbours compare all of their corners.
inline constexpr std::size_t mostCorners = 10000;

/// Collects the problems of a scene.
struct CheckReport {
    std::vector<Problem> problems;

    /// True if no more errors are added, so that remedies need not be found.
    bool isFull() const { return keyblock::isFull(problems); }
    void error(std::string pointer, std::string message, std::string remedy, Repair repair = {});
    void warning(std::string pointer, std::string message, std::string remedy, Repair repair = {});
    void note(std::string pointer, std::string message, std::string remedy);
};

/// State of the check of one scene, passed from part to part.
struct CheckContext {
    const Scene& scene;  // after the cut, if there was one
    double tolerance = 0.0;  // geometric tolerance [m]
    std::vector<bool> sound;  // per block: the outline is valid, so that points can be located in it
    std::vector<bool> fixed;  // per block: fixed as a whole
    const Scene& document;  // the scene as given, before the cut
    bool isCut = true;  // false if errors prevented the cut, so that blocks are missing
    CheckReport& report;

    bool allSound() const;  // all blocks are there and valid, and there is at least one
};

/// Checks all fields of `object` and of the objects in it against the field table: numbers must be finite and in range,
/// required strings must not be empty, and the conditions of fields must be met.
void checkFields(const Structure& structure, const void* object, const std::string& pointer, CheckReport& report);

/// Checks that the numbers in a value are finite and in the range of its field.
void checkValue(const Field& field, const FieldValue& value, const std::string& pointer, CheckReport& report);

/// Checks all preconditions of `cutScene`. The check covers all objects that are cut, and the bolt patterns.
/// \pre `context.scene` is the scene before the cut.
void checkSection(CheckContext& context);

/// Reports every bolt that has the same name as a bolt pattern, including the bolts made from patterns.
void checkBoltNames(CheckContext& context);

/// Checks the outline of a block, domain or region: at least three and at most `mostCorners` corners, no repeated
/// corner, a positive area, and no self-intersection.
/// \param what the object as named in messages, e.g. `the block`.
/// \return false if the outline has an error.
bool checkOutline(const std::vector<Point>& points, const std::string& pointer, std::string_view what,
                  double tolerance, CheckReport& report);

/// Reports a name that is not among `names`. Empty names are ignored, because they are reported elsewhere.
/// \param names the names in the scene's list `list`.
/// \param list the key of that list.
void checkReference(const std::string& name, const std::vector<std::string_view>& names, std::string_view list,
                    const std::string& pointer, CheckReport& report);

/// Names of the entries of a map, or of a list of named objects.
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

void checkRock(CheckContext& context);  // blocks, materials, supports; sets `sound` and `fixed`
void checkBodies(CheckContext& context);  // cells, and plates modelled as blocks; after `checkRock` and `checkBolts`
void checkBoltTypes(CheckContext& context);
void checkBolts(CheckContext& context);
void checkStages(CheckContext& context);
void checkAccelerations(const Stage& stage, const std::string& pointer, CheckContext& context);
void checkLengthOfRecords(CheckContext& context);
void checkStrengthChanges(const Stage& stage, const std::string& pointer, CheckContext& context);
void checkActivation(CheckContext& context);  // names that stages excavate, install and remove
void checkStiffness(CheckContext& context);  // loads and motion against stiffness and time step; after all others
void checkWatch(CheckContext& context);  // monitors, quantities and expected values

/// True if the bolt runs through a valid block that is not excavated.
/// \param gone true for each block that is excavated, indexed by block; empty: no block is excavated.
bool runsThroughRock(const Bolt& bolt, const CheckContext& context, const std::vector<bool>& gone);

/// Checks the anchors of a bolt type or bolt, except their positions along the bolt.
void checkAnchors(const std::vector<Anchor>& anchors, const std::string& pointer, CheckReport& report);

/// Reports a reference to a block that has been excavated by the start of a stage.
/// \param block the index of the block; −1 is ignored.
void checkStands(int block, std::size_t stage, const std::string& pointer, CheckContext& context);

/// Index of the block that contains a `block_at` point; −1 if there is no such block. The error is then reported, but
/// only if all blocks are valid.
int checkBlockAt(CheckContext& context, const Point& place, const std::string& pointer);

/// Index of the block that contains a point inside it or on its boundary; −1 if there is no such block. The error is
/// then reported, but only if all blocks are valid.
int checkPointOnBlock(CheckContext& context, const Point& point, const std::string& pointer);

/// Reports an axis of zero length.
void checkAxis(const Point& axis, const std::string& pointer, CheckReport& report);

/// Reports every name that is already used by an earlier item; empty names are ignored.
/// \param count the number of items; `nameOf` and `pointerOf` are called with indices from 0 to `count` − 1.
/// \param what one such item as named in messages, e.g. `bolt`.
void checkNamesDiffer(std::size_t count, const std::function<std::string(std::size_t)>& nameOf,
                      const std::function<std::string(std::size_t)>& pointerOf, std::string_view what,
                      CheckReport& report);

}  // namespace keyblock
