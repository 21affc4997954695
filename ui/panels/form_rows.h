// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contents of a form over one or several objects, made from the field table:
// groups of rows with values, which may be mixed or changed. Plain values; the form
// displays them.
#pragma once

#include "ui/panels/object_at.h"

#include <QString>

#include <string>
#include <vector>

namespace keyblock {

/// One field of all the objects that the form shows.
struct FormRow {
    std::string path;  // relative to each object, e.g. `until/unbalanced`
    std::vector<std::string> pointers;  // of the field, one for each object
    const Structure* structure = nullptr;
    const Field* field = nullptr;
    ObjectAt at{};  // the first object
    FieldValue value{};  // of the first
    FieldValue fallback{};  // where the key is missing
    bool mixed = false;  // the others differ
    bool changed = false;  // some differ from the fallback
    bool resettable = false;  // optional in the file
    bool renames = false;  // the name of an entry of a map, which is no field
};

/// Rows under one heading.
struct FormGroup {
    std::string id;  // the same for the same group of another object; at the top level its title
    QString title;
    QString detail;  // next to the title
    int depth = 0;
    bool closedAtFirst = false;
    std::vector<FormRow> rows;
    std::string addTo;  // pointer of a list, map or absent object that the user may add to; empty: none
    std::string remove;  // pointer of an item or object that may be removed; empty: none
};

/// Groups for the objects at `pointers`, all of one structure; none if their structures differ. Fields
/// that do not apply to all of them are left out; nested lists and objects are shown for a single object only.
std::vector<FormGroup> formGroups(const Scene& scene, const std::vector<std::string>& pointers);

/// The groups with the rows that contain `text` in label, key or help; empty groups are left out.
std::vector<FormGroup> matching(std::vector<FormGroup> groups, const QString& text);

}  // namespace keyblock
