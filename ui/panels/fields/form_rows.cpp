// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/fields/form_rows.h"

#include "solver/scene/pointer.h"
#include "ui/edit/pointer_change.h"
#include "ui/panels/fields/field_words.h"

#include <QCoreApplication>

#include <algorithm>

namespace keyblock {

namespace {

/// An object shown in the form, with its pointer.
struct Shown {
    std::string pointer;
    ObjectAt at;
};

/// Whether the field is a part of the scene that has its own row in the tree.
bool standsInTree(const Field& field) { return field.kind != FieldKind::Object || field.nullable; }

bool appliesToAll(const std::vector<Shown>& objects, const Field& field) {
    return std::ranges::all_of(objects, [&](const Shown& shown) {
        return applies(*shown.at.structure, field, shown.at.object);
    });
}

FormRow rowOf(const std::vector<Shown>& objects, const Field& field, const std::string& prefix) {
    FormRow row;
    row.path = prefix + std::string(field.key);
    row.structure = objects.front().at.structure;
    row.field = &field;
    row.at = objects.front().at;
    row.value = field.get(row.at.object);
    row.fallback = defaultOf(*row.structure, field);
    row.resettable = !field.required;
    for (const Shown& shown : objects) {
        const FieldValue value = field.get(shown.at.object);
        row.pointers.push_back(under(shown.pointer, field.key));
        row.mixed = row.mixed || value != row.value;
        row.changed = row.changed || (row.resettable && value != row.fallback);
    }
    return row;
}

FormGroup& groupTitled(std::vector<FormGroup>& groups, const QString& title, int depth, const std::string& prefix) {
    const std::string id = prefix + title.toStdString();
    for (FormGroup& group : groups)
        if (group.id == id) return group;
    FormGroup group;
    group.id = id;
    group.title = title;
    group.depth = depth;
    groups.push_back(std::move(group));
    return groups.back();
}

class Groups {
public:
    explicit Groups(std::vector<FormGroup>& groups) : groups_(groups) {}

    /// Adds rows for the fields of the objects themselves, then groups for nested objects.
    void addObjects(const std::vector<Shown>& objects, const std::string& prefix, const QString& title, int depth) {
        const Structure& structure = *objects.front().at.structure;
        std::vector<FormGroup> own;
        if (!title.isEmpty()) groupTitled(own, title, depth, prefix);
        for (const Field& field : structure.fields) {
            if (!field.get || !appliesToAll(objects, field)) continue;
            const bool isApart = !title.isEmpty() && field.isRare;
            const QString heading = title.isEmpty() || isApart ? headingOf(structure, field) : title;
            FormGroup& group = groupTitled(own, heading, isApart ? depth + 1 : depth, prefix);
            const bool isOfScene = !title.isEmpty() || !objects.front().at.holder;
            group.closedAtFirst = group.closedAtFirst || (field.isRare && isOfScene);
            group.rows.push_back(rowOf(objects, field, prefix));
        }
        std::ranges::move(own, std::back_inserter(groups_));
        for (const Field& field : structure.fields)
            if (hasChildren(field) && appliesToAll(objects, field))
                addInside(objects, field, prefix, title.isEmpty() ? depth : depth + 1);
    }

private:
    void addInside(const std::vector<Shown>& objects, const Field& field, const std::string& prefix, int depth) {
        if (objects.front().at.holder == nullptr && standsInTree(field)) return;
        const std::string path = prefix + std::string(field.key) + '/';
        if (field.kind == FieldKind::Object)
            addObject(objects, field, path, depth);
        else if (objects.size() == 1)
            addList(objects.front(), field, path, depth);
    }

    void addObject(const std::vector<Shown>& objects, const Field& field, const std::string& path, int depth) {
        const auto isNull = [&](const Shown& shown) { return field.children.isNull(shown.at.object); };
        if (std::ranges::any_of(objects, isNull)) {
            if (objects.size() == 1) groups_.push_back(absent(objects.front(), field, path, depth));
            return;
        }
        const std::size_t first = groups_.size();
        addObjects(inside(objects, field), path, labelOf(field), depth);
        if (first == groups_.size()) return;
        groups_[first].closedAtFirst = groups_[first].closedAtFirst || field.isRare;
        if (field.nullable && objects.size() == 1) groups_[first].remove = under(objects.front().pointer, field.key);
    }

    /// Adds a list or a map: one heading with the number of items, then a group for each item.
    void addList(const Shown& owner, const Field& field, const std::string& path, int depth) {
        const std::size_t count = field.children.count(owner.at.object);
        FormGroup head = absent(owner, field, path, depth);
        head.detail = count == 0 ? QString() : QString::number(count);
        if (field.children.isNull(owner.at.object))
            head.detail = QCoreApplication::translate("FormRows", "from the bolt type");
        if (field.nullable && !field.children.isNull(owner.at.object)) head.remove = under(owner.pointer, field.key);
        groups_.push_back(std::move(head));
        for (std::size_t i = 0; i < count; ++i) addItem(owner, field, i, path, depth + 1);
    }

    void addItem(const Shown& owner, const Field& field, std::size_t index, const std::string& path, int depth) {
        const std::string list = under(owner.pointer, field.key);
        const bool isMap = field.kind == FieldKind::Map;
        const std::string_view key = isMap ? field.children.name(owner.at.object, index) : std::string_view();
        const std::string pointer = isMap ? under(list, key) : under(list, index);
        const ObjectAt at{&field.children.structure(), field.children.item(owner.at.object, index), &field,
                          owner.at.structure, owner.at.object};
        const QString title = isMap ? fromUtf8(key) : QString("%1 %2").arg(titleOf(*at.structure)).arg(index + 1);
        const std::size_t first = groups_.size();
        addObjects({Shown{pointer, at}}, path + std::to_string(index) + '/', title, depth);
        groups_[first].remove = pointer;
        groups_[first].closedAtFirst = field.children.count(owner.at.object) > 2;
    }

    FormGroup absent(const Shown& owner, const Field& field, const std::string& path, int depth) const {
        FormGroup group;
        group.id = path;
        group.title = labelOf(field);
        group.depth = depth;
        group.addTo = under(owner.pointer, field.key);
        return group;
    }

    static std::vector<Shown> inside(const std::vector<Shown>& objects, const Field& field) {
        std::vector<Shown> found;
        for (const Shown& shown : objects)
            found.push_back({under(shown.pointer, field.key),
                             ObjectAt{&field.children.structure(), field.children.item(shown.at.object, 0), &field,
                                      shown.at.structure, shown.at.object}});
        return found;
    }

    std::vector<FormGroup>& groups_;
};

/// Adds a row for the name of a map entry. The name is the key and not a field, but users look for it among the fields.
void addNameOfMapEntry(std::vector<FormGroup>& groups, const Shown& shown) {
    static const Field nameField{.key = "name", .kind = FieldKind::Text,
                                 .help = "Name used by other objects to refer to this one.", .required = true};
    if (!shown.at.holder || shown.at.holder->kind != FieldKind::Map || groups.empty()) return;
    FormRow row;
    row.path = "name";
    row.pointers = {shown.pointer};
    row.structure = shown.at.structure;
    row.field = &nameField;
    row.at = shown.at;
    row.value = partsOf(shown.pointer).back();
    row.renames = true;
    groups.front().rows.insert(groups.front().rows.begin(), std::move(row));
}

/// Removes the rows for names, because several objects cannot share one name.
void withoutNames(std::vector<FormGroup>& groups) {
    for (FormGroup& group : groups)
        std::erase_if(group.rows, [](const FormRow& row) { return isName(*row.field); });
}

bool holds(const FormRow& row, const QString& text) {
    return labelOf(*row.field).contains(text, Qt::CaseInsensitive) ||
           fromUtf8(row.field->key).contains(text, Qt::CaseInsensitive) ||
           fromUtf8(row.field->help).contains(text, Qt::CaseInsensitive);
}

}  // namespace

std::vector<FormGroup> formGroups(const Scene& scene, const std::vector<std::string>& pointers) {
    std::vector<Shown> objects;
    for (const std::string& pointer : pointers) {
        const auto at = objectAt(scene, pointer);
        if (!at) continue;
        if (!objects.empty() && at->structure != objects.front().at.structure) return {};  // they have no common fields
        objects.push_back({pointer, *at});
    }
    std::vector<FormGroup> groups;
    if (objects.empty()) return groups;
    Groups(groups).addObjects(objects, "", QString(), 0);
    if (objects.size() == 1) addNameOfMapEntry(groups, objects.front());
    if (objects.size() > 1) withoutNames(groups);
    return groups;
}

std::vector<FormGroup> matching(std::vector<FormGroup> groups, const QString& text) {
    if (text.isEmpty()) return groups;
    for (FormGroup& group : groups)
        if (!group.title.contains(text, Qt::CaseInsensitive))
            std::erase_if(group.rows, [&](const FormRow& row) { return !holds(row, text); });
    std::erase_if(groups, [](const FormGroup& group) { return group.rows.empty(); });
    return groups;
}

}  // namespace keyblock
