// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a row of the field table from a member of a struct. The kind, the words and
// the access functions follow from the type of the member; `Says` gives the rest.
// Only source files that contain rows include this header.
#pragma once

#include "solver/scene/field.h"
#include "solver/scene/lookup.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/structures.h"
#include "solver/scene/translatable.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

namespace keyblock {

/// Options of a table row that cannot be derived from the member; see `Field`.
struct Says {
    std::string_view label{};
    std::string_view unit{};
    bool isModulus = false;
    bool (*takesSecond)(const void* object, const void* owner) = nullptr;
    std::vector<PairColumn> columns{};
    Range range{};
    bool required = false;
    bool emptyIsNull = false;  // null means the empty string, list or table
    bool emptyIsZero = false;
    bool isStress = false;
    bool isAxis = false;
    Only only{};
    std::vector<std::string_view> laterWords{};
    std::string_view source{};
    Words words{};  // for a TextList
    std::vector<std::string_view> names{};
    bool namesSingleBolts = false;
    std::string_view heading{};
    bool isRare = false;
    bool isSentence = false;
    bool isOrdered = false;
    FieldValue (*automatic)(const Scene& scene, const SceneCut* cut, const void* object) = nullptr;
    std::string_view nullText{};
};

/// Valid range of coordinates [m].
inline constexpr Range coordinates{.least = -farthestCoordinate, .most = farthestCoordinate};

/// Valid ranges of densities and moduli. They are much wider than those of real solids, but narrow enough that products
/// of such numbers do not overflow or underflow.
inline constexpr Range densities{.least = 1e-6, .most = 1e9};  // [kg/m³]
inline constexpr Range moduli{.least = 1.0, .most = 1e18};  // [Pa]

inline Range above(double least) { return {.least = least, .leastExcluded = true}; }
inline Range atLeast(double least) { return {.least = least}; }
inline Range within(double least, double most) { return {.least = least, .most = most}; }
inline Range between(double least, double most) {
    return {.least = least, .most = most, .leastExcluded = true, .mostExcluded = true};
}

namespace rows {

template <typename T>
struct MemberOf;
template <typename Owner, typename Value>
struct MemberOf<Value Owner::*> {
    using OwnerType = Owner;
    using ValueType = Value;
};

template <typename T>
struct Optional : std::false_type {
    using Inner = T;
};
template <typename T>
struct Optional<std::optional<T>> : std::true_type {
    using Inner = T;
};

// A single struct, a list of structs, or a list of structs with names.
template <typename T>
struct Holder {
    using Item = T;
    static constexpr FieldKind kind = FieldKind::Object;
};
template <typename T>
struct Holder<std::vector<T>> {
    using Item = T;
    static constexpr FieldKind kind = FieldKind::List;
};
template <typename T>
struct Holder<std::vector<std::pair<std::string, T>>> {
    using Item = T;
    static constexpr FieldKind kind = FieldKind::Map;
};
template <>
struct Holder<std::vector<BoltType>> {
    using Item = BoltType;
    static constexpr FieldKind kind = FieldKind::Map;
};

template <typename T>
concept HasStructure = requires(const T* item) { structureOf(item); };

template <auto member>
using Owner = typename MemberOf<decltype(member)>::OwnerType;
template <auto member>
using Value = typename MemberOf<decltype(member)>::ValueType;
template <auto member>
using Inner = typename Optional<Value<member>>::Inner;
template <auto member>
constexpr bool isOptional = Optional<Value<member>>::value;

template <typename T>
constexpr FieldKind leafKind() {
    if constexpr (std::is_same_v<T, bool>) return FieldKind::Flag;
    if constexpr (std::is_same_v<T, double>) return FieldKind::Number;
    if constexpr (std::is_same_v<T, int>) return FieldKind::Integer;
    if constexpr (std::is_same_v<T, std::string>) return FieldKind::Text;
    if constexpr (std::is_enum_v<T>) return FieldKind::Word;
    if constexpr (std::is_same_v<T, Point>) return FieldKind::Vector;
    if constexpr (std::is_same_v<T, std::array<Point, 2>>) return FieldKind::PointPair;
    if constexpr (std::is_same_v<T, std::vector<Point>>) return FieldKind::Points;
    if constexpr (std::is_same_v<T, Table>) return FieldKind::Pairs;
    if constexpr (std::is_same_v<T, Stress>) return FieldKind::Triple;
    if constexpr (std::is_same_v<T, BoltPlace>) return FieldKind::Place;
    if constexpr (std::is_same_v<T, std::vector<std::string>>) return FieldKind::TextList;
    if constexpr (std::is_same_v<T, std::map<std::string, std::string>>) return FieldKind::TextMap;
}

template <typename T>
FieldValue toValue(const T& held) {
    if constexpr (std::is_enum_v<T>)
        return std::string(wordsOf(held)[static_cast<std::size_t>(held)]);
    else if constexpr (std::is_same_v<T, int>)
        return static_cast<double>(held);
    else if constexpr (std::is_same_v<T, std::array<Point, 2>>)
        return std::vector<Point>(held.begin(), held.end());
    else
        return held;
}

template <typename T>
T fromValue(const FieldValue& value) {
    if constexpr (std::is_enum_v<T>) {
        const Words words = wordsOf(T{});
        return static_cast<T>(std::find(words.begin(), words.end(), std::get<std::string>(value)) - words.begin());
    } else if constexpr (std::is_same_v<T, int>) {
        return static_cast<int>(std::get<double>(value));
    } else if constexpr (std::is_same_v<T, std::array<Point, 2>>) {
        const auto& points = std::get<std::vector<Point>>(value);
        return {points.at(0), points.at(1)};
    } else {
        return std::get<T>(value);
    }
}

template <auto member>
FieldValue get(const void* owner) {
    const auto& held = static_cast<const Owner<member>*>(owner)->*member;
    if constexpr (isOptional<member>)
        return held ? toValue(*held) : FieldValue{};
    else
        return toValue(held);
}

template <auto member>
void set(void* owner, const FieldValue& value) {
    auto& held = static_cast<Owner<member>*>(owner)->*member;
    if (!std::holds_alternative<std::monostate>(value))
        held = fromValue<Inner<member>>(value);
    else if constexpr (isOptional<member>)
        held.reset();
    else if constexpr (requires { held.clear(); })
        held.clear();
}

/// Implements the functions of `Children` for one member.
template <auto member>
struct Reach {
    using Held = Holder<Inner<member>>;
    using Item = typename Held::Item;

    static auto& valueOf(void* owner) { return static_cast<Owner<member>*>(owner)->*member; }
    static const auto& valueOf(const void* owner) { return static_cast<const Owner<member>*>(owner)->*member; }

    static bool isNull(const void* owner) {
        if constexpr (isOptional<member>)
            return !valueOf(owner).has_value();
        else
            return false;
    }
    static auto& inner(void* owner) {
        if constexpr (isOptional<member>)
            return *valueOf(owner);
        else
            return valueOf(owner);
    }
    static const auto& inner(const void* owner) { return inner(const_cast<void*>(owner)); }

    static std::size_t count(const void* owner) {
        if constexpr (Held::kind == FieldKind::Object)
            return isNull(owner) ? 0 : 1;
        else
            return isNull(owner) ? 0 : inner(owner).size();
    }
    static const void* item(const void* owner, std::size_t index) {
        if constexpr (Held::kind == FieldKind::Object)
            return &inner(owner);
        else if constexpr (std::is_same_v<typename std::decay_t<decltype(inner(owner))>::value_type, Item>)
            return &inner(owner)[index];
        else
            return &inner(owner)[index].second;
    }
    static std::string_view name(const void* owner, std::size_t index) {
        if constexpr (std::is_same_v<Item, BoltType>)
            return inner(owner)[index].name;
        else if constexpr (Held::kind == FieldKind::Map)
            return inner(owner)[index].first;
        else
            return {};
    }
    static void clear(void* owner) {
        if constexpr (Held::kind != FieldKind::Object)
            valueOf(owner) = Inner<member>{};
    }
    static void setNull(void* owner) { valueOf(owner) = Value<member>{}; }
    static BoltType& named(BoltType& type, std::string_view typeName) {
        type.name = typeName;
        return type;
    }
    static void* append(void* owner, [[maybe_unused]] std::string_view itemName) {
        if constexpr (isOptional<member>)
            if (Held::kind == FieldKind::Object || isNull(owner)) valueOf(owner).emplace();
        if constexpr (Held::kind == FieldKind::Object)
            return &inner(owner);
        else if constexpr (std::is_same_v<Item, BoltType>)
            return &named(inner(owner).emplace_back(), itemName);
        else if constexpr (Held::kind == FieldKind::Map)
            return &inner(owner).emplace_back(std::string(itemName), Item{}).second;
        else
            return &inner(owner).emplace_back();
    }
    static void assign(void* item, const void* from) {
        auto& to = *static_cast<Item*>(item);
        if constexpr (std::is_same_v<Item, BoltType>) {
            std::string kept = std::move(to.name);
            to = *static_cast<const Item*>(from);
            to.name = std::move(kept);
        } else {
            to = *static_cast<const Item*>(from);
        }
    }
    static void erase(void* owner, [[maybe_unused]] std::size_t index) {
        if constexpr (Held::kind != FieldKind::Object)
            inner(owner).erase(inner(owner).begin() + static_cast<std::ptrdiff_t>(index));
    }
    static void move([[maybe_unused]] void* owner, [[maybe_unused]] std::size_t from,
                     [[maybe_unused]] std::size_t to) {
        if constexpr (Held::kind != FieldKind::Object) {
            const auto begin = inner(owner).begin();
            const auto at = [&](std::size_t index) { return begin + static_cast<std::ptrdiff_t>(index); };
            if (from < to)
                std::rotate(at(from), at(from + 1), at(to + 1));
            else
                std::rotate(at(to), at(from), at(from + 1));
        }
    }
    static void rename([[maybe_unused]] void* owner, [[maybe_unused]] std::size_t index,
                       [[maybe_unused]] std::string_view itemName) {
        if constexpr (std::is_same_v<Item, BoltType>)
            inner(owner)[index].name = itemName;
        else if constexpr (Held::kind == FieldKind::Map)
            inner(owner)[index].first = itemName;
    }
    static const Structure& structure() { return structureOf(static_cast<const Item*>(nullptr)); }
};

constexpr bool holdsPoints(FieldKind kind) {
    return kind == FieldKind::Vector || kind == FieldKind::PointPair || kind == FieldKind::Points;
}

template <auto member>
void describeAccess(Field& field) {
    if constexpr (HasStructure<typename Holder<Inner<member>>::Item>) {
        using R = Reach<member>;
        field.kind = R::Held::kind;
        field.children = {R::count,  R::item,   R::name,  R::isNull, R::clear,  R::setNull,
                          R::append, R::assign, R::erase, R::move,   R::rename, R::structure};
    } else {
        field.kind = leafKind<Inner<member>>();
        field.get = get<member>;
        field.set = set<member>;
        if constexpr (std::is_enum_v<Inner<member>>) {
            field.words = wordsOf(Inner<member>{});
            field.wordLabels = labelsOf(Inner<member>{});
        }
    }
}

}  // namespace rows

/// Creates the row of a member, e.g. `row<&Block::points>("points", "Corners…", {.unit = "m", .required = true})`.
template <auto member>
Field row(std::string_view key, std::string_view help, Says says = {}) {
    Field field{.key = key, .label = says.label, .unit = says.unit, .help = help, .source = says.source,
                .range = says.range};
    field.isModulus = says.isModulus;
    field.takesSecond = says.takesSecond;
    field.columns = std::move(says.columns);
    field.required = says.required;
    field.nullable = rows::isOptional<member> || says.emptyIsNull;
    field.emptyIsNull = says.emptyIsNull;
    field.emptyIsZero = says.emptyIsZero;
    field.isStress = says.isStress;
    field.only = std::move(says.only);
    field.laterWords = std::move(says.laterWords);
    field.words = says.words;
    field.names = std::move(says.names);
    field.namesSingleBolts = says.namesSingleBolts;
    field.heading = says.heading;
    field.isRare = says.isRare;
    field.isSentence = says.isSentence;
    field.isOrdered = says.isOrdered;
    field.automatic = says.automatic;
    field.nullText = says.nullText;
    rows::describeAccess<member>(field);
    if (says.isAxis)
        field.kind = FieldKind::Axis;
    else if (says.unit == "m" && rows::holdsPoints(field.kind))
        field.range = coordinates;
    return field;
}

namespace rows {

template <typename Result>
FieldValue automaticValue(Result (*function)(const Scene&), const Scene& scene, const void*) {
    return FieldValue(function(scene));
}
template <typename Result, typename Object>
FieldValue automaticValue(Result (*function)(const Object&), const Scene&, const void* object) {
    return FieldValue(function(*static_cast<const Object*>(object)));
}
template <typename Object>
FieldValue automaticValue(FieldValue (*function)(const Scene&, const Object&), const Scene& scene, const void* object) {
    return function(scene, *static_cast<const Object*>(object));
}

}  // namespace rows

/// Calls `function` with the arguments that it takes: the scene, the object that contains the field, or both. Has the
/// signature of `Field::automatic`.
template <auto function>
FieldValue automatic(const Scene& scene, const SceneCut*, const void* object) {
    return rows::automaticValue(function, scene, object);
}

/// Creates a table row for a key without a member. The key accepts only the values in `accepted`, which have no effect.
Field fixedRow(std::string_view key, std::string_view help, std::vector<FieldValue> accepted, bool required = false);

/// A default-constructed T, from which the field table of T reads the default values.
template <typename T>
const void* defaultsOf() {
    static const T defaults{};
    return &defaults;
}

}  // namespace keyblock
