// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reader loops over the members in the file rather than over the fields of the
// struct. For missing keys the target therefore keeps its values: its defaults, or
// those copied from another object.
#include "solver/files/json/object_reader.h"

#include "solver/files/json/field_json.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <limits>

namespace keyblock {

namespace {

class ObjectReader {
public:
    ObjectReader(const Structure& structure, void* target, const std::string& pointer, std::vector<Problem>& problems)
        : structure_(structure), target_(target), pointer_(pointer), problems_(problems) {}

    void read(const JsonNode& node, const std::vector<std::string_view>& skipped) {
        const auto* members = std::get_if<JsonObject>(&node.value);
        if (!members)
            return addError(problems_, node, pointer_,
                            "this is " + std::string(kindText(node)) + " where an object is expected",
                            "Write { … } with the keys of a " + std::string(structure_.name));
        for (const JsonMember& member : *members)
            if (!isFull(problems_) && std::find(skipped.begin(), skipped.end(), member.key) == skipped.end())
                readMember(member);
        reportMissing(node);
        reportMisplaced(*members);
    }

private:
    void readMember(const JsonMember& member) {
        const std::string place = under(pointer_, member.key);
        const Field* field = findField(structure_, member.key);
        if (!field)
            return addError(problems_, member.node, place,
                            "the " + std::string(structure_.name) + " has no key " + inQuotes(member.key),
                            suggestion(member.key, keys()));
        if (hasChildren(*field))
            return readChildren(*field, member.node, place);
        const auto value = valueFromJson(*field, member.node, place, problems_);
        if (!value)
            markUnread(*field);
        else if (field->set)
            field->set(target_, *value);
    }

    // A position that could not be read must not be taken for the origin in later checks.
    void markUnread(const Field& field) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        if (field.kind == FieldKind::Vector)
            field.set(target_, Point(none, none));
    }

    void readChildren(const Field& field, const JsonNode& node, const std::string& place) {
        const Children& children = field.children;
        if (field.nullable && std::holds_alternative<std::monostate>(node.value))
            return children.setNull(target_);
        if (field.kind == FieldKind::Object)
            return readObject(node, children.structure(), children.append(target_, {}), place, problems_);
        children.clear(target_);
        if (field.kind == FieldKind::List)
            readList(field, node, place);
        else
            readMap(field, node, place);
    }

    void readList(const Field& field, const JsonNode& node, const std::string& place) {
        const auto* list = std::get_if<JsonList>(&node.value);
        if (!list)
            return addError(problems_, node, place,
                            inQuotes(field.key) + " is " + std::string(kindText(node)) + ", but must be a list",
                            "Write [ … ] with an object for each item");
        for (std::size_t i = 0; i < list->size() && !isFull(problems_); ++i)
            readObject((*list)[i], field.children.structure(), field.children.append(target_, {}), under(place, i),
                       problems_);
    }

    void readMap(const Field& field, const JsonNode& node, const std::string& place) {
        const auto* object = std::get_if<JsonObject>(&node.value);
        if (!object)
            return addError(problems_, node, place,
                            inQuotes(field.key) + " is " + std::string(kindText(node)) +
                                ", but must be an object with named members",
                            "Write { \"name\": { … } }");
        for (const JsonMember& member : *object)
            if (!isFull(problems_))
                readObject(member.node, field.children.structure(), field.children.append(target_, member.key),
                           under(place, member.key), problems_);
    }

    void reportMissing(const JsonNode& node) {
        for (const Field& field : structure_.fields) {
            if (!field.required || findMember(node, field.key))
                continue;
            markUnread(field);
            addError(problems_, node, under(pointer_, field.key),
                     "the " + std::string(structure_.name) + " has no " + inQuotes(field.key),
                     "Add it: " + std::string(field.help));
        }
    }

    // Reports fields that are present where they do not apply. There, even the default value is a mistake; null means
    // no value and is allowed anywhere.
    void reportMisplaced(const JsonObject& members) {
        for (const JsonMember& member : members) {
            if (isFull(problems_)) return;
            const Field* field = findField(structure_, member.key);
            if (!field || std::holds_alternative<std::monostate>(member.node.value) || isInDoubt(*field))
                continue;
            if (!applies(structure_, *field, target_))
                addError(problems_, member.node, under(pointer_, member.key), misplaced(*field), "Remove it");
        }
    }

    // True if the field that decides whether this one applies has an error of its own.
    bool isInDoubt(const Field& field) const {
        const std::string decider = under(pointer_, field.only.key);
        return !field.only.key.empty() &&
               std::any_of(problems_.begin(), problems_.end(),
                           [&](const Problem& problem) { return problem.pointer == decider; });
    }

    std::vector<std::string_view> keys() const {
        std::vector<std::string_view> all;
        for (const Field& field : structure_.fields)
            all.push_back(field.key);
        return all;
    }

    const Structure& structure_;
    void* target_;
    const std::string& pointer_;
    std::vector<Problem>& problems_;
};

}  // namespace

void readObject(const JsonNode& node, const Structure& structure, void* target, const std::string& pointer,
                std::vector<Problem>& problems, const std::vector<std::string_view>& skipped) {
    if (!isFull(problems))
        ObjectReader(structure, target, pointer, problems).read(node, skipped);
}

}  // namespace keyblock
