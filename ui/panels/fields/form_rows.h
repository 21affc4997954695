// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contents of a form for one or several objects, generated from the field table:
// groups of rows with values, which may differ between the objects or from the default.
// Plain values; the form displays them.
#pragma once

#include "ui/panels/fields/object_at.h"

#include <QString>

#include <string>
#include <vector>

namespace keyblock {

/// One field of all objects in the form.
struct FormRow {
    std::string path;  // relative to each object, e.g. `until/unbalanced`
    std::vector<std::string> pointers;  // pointers to this field, one per object
    const Structure* structure = nullptr;
    const Field* field = nullptr;
    ObjectAt at{};  // the first object
    FieldValue value{};  // value of the first object
    FieldValue fallback{};  // default used if the key is missing
    bool mixed = false;  // true if other objects have a different value
    bool changed = false;  // true if any value differs from the default
    bool resettable = false;  // true if the key is optional in the file
    bool renames = false;  // true for the name of a map entry, which is not a field
};

/// A group of rows under one heading.
struct FormGroup {
    std::string id;  // equal for the same group of another object; the title for groups at the top level
    QString title;
    QString detail;  // shown next to the title
    int depth = 0;
    bool closedAtFirst = false;
    std::vector<FormRow> rows;
    std::string addTo;  // pointer to a list, map or absent object to which the user can add; empty: none
    std::string remove;  // pointer to an item or object that the user can remove; empty: none
};

/// Groups for the objects at `pointers`; none if the objects have different structures. Fields that do not apply to
/// every object are left out. Lists and maps are shown for a single object only, and nested objects only if every
/// object has them.
std::vector<FormGroup> formGroups(const Scene& scene, const std::vector<std::string>& pointers);

/// Returns the rows whose label, key or help contains `text`, and all rows of a group whose title contains it. Groups
/// without rows are left out.
std::vector<FormGroup> matching(std::vector<FormGroup> groups, const QString& text);

}  // namespace keyblock
