// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The source of a number is that of the number itself, or else that of the part to
// which it belongs, or else that of the whole type. A value left at its default has
// the source of the default, unless it is given its own.
#include "app/cli/bolt_listing.h"

#include "solver/scene/field.h"
#include "solver/scene/number_text.h"

#include <variant>

namespace keyblock::cli {

namespace {

/// The value as written in a scene file, without quotes; empty for null.
struct ValueText {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(double value) const { return shortest(value); }
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(const BoltPlace& value) const { return value.head ? "head" : shortest(value.s); }

    /// The only lists in a bolt type are lists of pairs, which are listed one by one.
    template <typename Other>
    std::string operator()(const Other&) const {
        return {};
    }
};

bool isNumeric(FieldKind kind) { return kind != FieldKind::Word && kind != FieldKind::Flag && kind != FieldKind::Text; }

class Listing {
public:
    explicit Listing(const BoltType& type) : type_(type) {}

    std::vector<BoltNumber> list() {
        walk(boltTypeStructure(), &type_, "");
        return std::move(numbers_);
    }

private:
    void walk(const Structure& structure, const void* object, const std::string& prefix) {
        for (const Field& field : structure.fields) {
            if (!applies(structure, field, object))
                continue;
            if (hasChildren(field))
                walkChildren(field, object, prefix + std::string(field.key));
            else if (field.get)
                add(structure, field, object, prefix);
        }
    }

    void walkChildren(const Field& field, const void* object, const std::string& path) {
        for (std::size_t index = 0; index < field.children.count(object); ++index) {
            const std::string place = field.kind == FieldKind::List ? "[" + std::to_string(index) + "]" : "";
            walk(field.children.structure(), field.children.item(object, index), path + place + ".");
        }
    }

    void add(const Structure& structure, const Field& field, const void* object, const std::string& prefix) {
        const FieldValue value = field.get(object);
        const std::string path = prefix + std::string(field.key);
        if (path == "source" || path == "like" || path == "class")
            return;
        const bool isDefault = !field.required && value == defaultOf(structure, field);
        BoltNumber number{path, std::visit(ValueText{}, value), std::string(field.unit), ""};
        number.source = sourceOf(path, field, isDefault);
        number.confirmed = number.source.find("unconfirmed") == std::string::npos;
        if (const Table* pairs = std::get_if<Table>(&value))
            addPairs(*pairs, number);
        else if (!number.value.empty())
            numbers_.push_back(number);
    }

    /// Adds one entry for each pair, all with the same source.
    void addPairs(const Table& pairs, const BoltNumber& like) {
        for (std::size_t index = 0; index < pairs.size(); ++index) {
            BoltNumber number = like;
            number.key += "[" + std::to_string(index) + "]";
            number.value = shortest(pairs[index].first) + ", " + shortest(pairs[index].second);
            numbers_.push_back(number);
        }
    }

    std::string sourceOf(const std::string& path, const Field& field, bool isDefault) const {
        if (const auto own = type_.sources.find(path); own != type_.sources.end())
            return own->second;
        if (!isNumeric(field.kind))
            return {};
        if (isDefault)
            return field.source.empty() ? "program default" : std::string(field.source);
        const std::string part = partSource(path);
        return part.empty() ? type_.source : part;
    }

    /// The source given for the smallest part that contains the path; empty if there is none.
    std::string partSource(std::string path) const {
        while (!path.empty()) {
            if (const auto found = type_.sources.find(path); found != type_.sources.end())
                return found->second;
            const auto end = path.find_last_of(".[");
            path.resize(end == std::string::npos ? 0 : end);
        }
        return {};
    }

    const BoltType& type_;
    std::vector<BoltNumber> numbers_;
};

}  // namespace

std::vector<BoltNumber> numbersOf(const BoltType& type) { return Listing(type).list(); }

}  // namespace keyblock::cli
