// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One table defines everything about the fields of a scene: name in the file, kind,
// unit, default, range, help. Reading, writing, the JSON Schema, the checks of
// ranges and the reference page are made from it, so that a new field is one row
// here and one member in scene.h.
//
// The rows are type-erased: values pass as one variant and objects as void
// pointers, whose type only the row knows. What walks the table is therefore
// compiled once and quickly, and never sees the structs of the scene.
#pragma once

#include "solver/scene/scene.h"

#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace keyblock {

/// What is in the file for a field.
enum class FieldKind {
    Flag, Number, Integer, Text,
    Word,  // one of a list of texts
    Vector,  // [x, y]
    Axis,  // "x", "y" or [x, y]
    PointPair,  // [[x, y], [x, y]]
    Points,  // [[x, y], …]
    Pairs,  // [[a, b], …]
    Triple,  // [sxx, syy, sxy]
    Place,  // a number or "head"
    TextList,
    TextMap,  // {name: text}
    Object,  // {…} of the row's structure
    List,  // [{…}, …]
    Map,  // {name: {…}}
    Fixed  // no member: only the listed values, which change nothing, are accepted
};

/// Any value of a field without a structure of its own; words as texts, integers as numbers, nothing as null.
using FieldValue = std::variant<std::monostate, bool, double, std::string, Point, std::vector<Point>, Table, Stress,
                                BoltPlace, std::vector<std::string>, std::map<std::string, std::string>>;

/// Numbers that a field takes.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool leastExcluded = false;
    bool mostExcluded = false;
};

/// The field makes sense only where another of the same object has one of these words, or is given at all.
struct Only {
    std::string_view key{};
    std::vector<std::string_view> words{};  // empty: where `key` is not null
};

/// A column of a table of pairs.
struct PairColumn {
    std::string_view title{};  // for people
    std::string_view unit{};  // empty: none
    std::string_view second{};  // the same where the field takes its second unit
};

struct Structure;
struct SceneCut;

/// How the objects inside an Object, List or Map are reached; `owner` is the struct that has the member.
struct Children {
    std::size_t (*count)(const void* owner) = nullptr;  // 0 when null; 1 of an Object
    const void* (*item)(const void* owner, std::size_t index) = nullptr;
    std::string_view (*name)(const void* owner, std::size_t index) = nullptr;  // of a Map, else empty
    bool (*isNull)(const void* owner) = nullptr;
    void (*clear)(void* owner) = nullptr;  // present and empty; leaves an Object as it is
    void (*setNull)(void* owner) = nullptr;  // of a nullable one
    void* (*append)(void* owner, std::string_view name) = nullptr;  // valid until the next; the member of an Object
    void (*assign)(void* item, const void* from) = nullptr;  // all but the name of a Map's entry
    void (*erase)(void* owner, std::size_t index) = nullptr;  // of a List or Map
    void (*move)(void* owner, std::size_t from, std::size_t to) = nullptr;  // of a List or Map; shifts those between
    void (*rename)(void* owner, std::size_t index, std::string_view name) = nullptr;  // of a Map
    const Structure& (*structure)() = nullptr;
};

/// One row of the table.
struct Field {
    std::string_view key{};
    FieldKind kind = FieldKind::Fixed;
    std::string_view label{};  // for people; empty: the key gives it, see `labelText`
    std::string_view unit{};  // as people write it, two as `a, or b`; empty: none
    bool isModulus = false;  // of elasticity: a window may show it in GPa where stresses are in MPa
    bool (*takesSecond)(const void* object, const void* owner) = nullptr;  // whether the second unit applies
    std::vector<PairColumn> columns{};  // of Pairs
    std::string_view help{};
    std::string_view source{};  // where the default comes from; empty: a choice of this program
    Range range{};
    bool required = false;
    bool nullable = false;  // null is a value of its own, or means the empty one
    bool emptyIsNull = false;  // the latter
    bool emptyIsZero = false;  // a Vector that may be written []
    bool isStress = false;  // of rock, positive in tension: a window may show it with the opposite sign
    Only only{};
    std::span<const std::string_view> words{};  // of a Word, or all texts that a TextList may have
    std::span<const std::string_view> wordLabels{};  // of `words`, for people; empty: the words themselves
    std::vector<std::string_view> laterWords{};  // words of the format that this program does not know
    std::vector<FieldValue> accepted{};  // of Fixed
    std::vector<std::string_view> names{};  // of a Text or TextList that names entries of these lists of the scene
    bool namesSingleBolts = false;  // in place of a bolt pattern its bolts: `P1.1`, `P1.2`, …
    std::string_view heading{};  // in a form, above it and its neighbours; empty: the name of the structure
    bool isRare = false;  // few users change it: closed at first in the form of the whole scene
    bool isSentence = false;  // a Text of several words
    bool isOrdered = false;  // a List whose order users choose
    /// The value that the program takes for null; null: it is only known in a run. `cut`: of the scene, if it was cut.
    FieldValue (*automatic)(const Scene& scene, const SceneCut* cut, const void* object) = nullptr;
    std::string_view nullText{};  // what null means where it is no value: `unlimited`
    FieldValue (*get)(const void* owner) = nullptr;
    void (*set)(void* owner, const FieldValue& value) = nullptr;  // of the right alternative
    Children children{};  // of Object, List and Map
};

/// The table of one struct.
struct Structure {
    std::string_view name{};  // in the schema and as a heading, e.g. "joint material"
    std::string_view help{};
    const void* defaults = nullptr;  // a default-made object of the struct
    std::vector<Field> fields{};
};

/// The whole scene's table; everything else hangs below it.
const Structure& sceneStructure();

/// The table of a bolt type, whose `like` a reader follows by itself.
const Structure& boltTypeStructure();

/// The scene's table and all below it, each once, in the order of the rows that lead to them.
std::vector<const Structure*> allStructures();

/// The row of that key; null when there is none.
const Field* findField(const Structure& structure, std::string_view key);

/// True for Object, List and Map.
bool hasChildren(const Field& field);

/// True for the field with the name of its object.
bool isName(const Field& field);

/// True for a Map, or a List of objects with a name.
bool hasNames(const Field& field);

/// The label of the field, or one made from its key: `Dip deviation`.
std::string labelText(const Field& field);

/// One of the field's words for people: `clockwise` for `cw`.
std::string_view wordLabel(const Field& field, std::string_view word);

/// What `field.automatic` gives; null: the field has no automatic value, or it is only known in a run.
FieldValue automaticOf(const Field& field, const Scene& scene, const SceneCut* cut, const void* object);

/// The unit in this object. `owner`: the object that has the list or member that holds it; null: not known.
std::string_view unitIn(const Field& field, const void* object, const void* owner);

/// The same of a column of Pairs.
std::string_view unitIn(const Field& field, const PairColumn& column, const void* object, const void* owner);

/// The value that the field has when its key is missing.
FieldValue defaultOf(const Structure& structure, const Field& field);

/// True when `field.only` is met by the other fields of `object`, or is empty.
bool applies(const Structure& structure, const Field& field, const void* object);

/// True when two objects of the field's struct say the same in it, down to the last value.
bool sameValue(const Field& field, const void* a, const void* b);

/// Where the field applies, e.g. `where 'kind' is 'dynamic'`. \pre it is not empty.
std::string condition(const Field& field);

/// Says of a misplaced field where it would apply.
std::string misplaced(const Field& field);

/// True when no number in the value is infinite or NaN.
bool isFinite(const FieldValue& value);

/// True when a number lies in the range.
bool contains(const Range& range, double number);

/// The range in words for people, e.g. `> 0`, `0 … 90`; empty when unlimited.
std::string rangeText(const Range& range);

}  // namespace keyblock
