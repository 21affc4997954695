// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a form over one or several objects shows, made from the field table: groups
// of rows with values, mixed or not, changed or not. Plain values; the form only
// puts them on the screen.
#pragma once

#include "ui/panels/object_at.h"

#include <QString>

#include <string>
#include <vector>

namespace keyblock {

/// One field of all the objects that the form shows.
struct FormRow {
    std::string path;  // below each object, e.g. `until/unbalanced`
    std::vector<std::string> pointers;  // of the field, one for each object
    const Structure* structure = nullptr;
    const Field* field = nullptr;
    ObjectAt at{};  // the first object
    FieldValue value{};  // of the first
    FieldValue fallback{};  // where the key is missing
    bool mixed = false;  // the others differ
    bool changed = false;  // some differ from the fallback
    bool resettable = false;  // may be left out of the file
    bool renames = false;  // the name of an entry of a map, which is no field
};

/// Rows under one heading.
struct FormGroup {
    std::string id;  // the same for the same group of another object; of those at the top its title
    QString title;
    QString detail;  // beside the title
    int depth = 0;
    bool closedAtFirst = false;
    std::vector<FormRow> rows;
    std::string addTo;  // pointer of a list, map or absent object that a person may add to; empty: none
    std::string remove;  // pointer of an item or object that may be taken away; empty: none
};

/// Groups for the objects at `pointers`, one or more of one structure; none where they are of several. Fields
/// that do not apply to all of them are left out; lists and objects inside are shown of a single one.
std::vector<FormGroup> formGroups(const Scene& scene, const std::vector<std::string>& pointers);

/// The groups with the rows that hold `text` in label, key or help; empty groups are left out.
std::vector<FormGroup> matching(std::vector<FormGroup> groups, const QString& text);

}  // namespace keyblock
