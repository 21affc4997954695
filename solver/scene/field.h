// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The field table: key, kind, unit, default, range and help of every field of a
// scene. The reader, the writer, the JSON Schema, the range checks and the
// reference page are all generated from it, so that a new field needs only one
// row and one member in scene.h.
//
// The rows are type-erased: values are passed as one variant type, and objects as
// void pointers whose type only the row knows. Code that traverses the table is
// therefore compiled only once and does not depend on the structs of the scene.
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

/// Kind of value that a field has in the file.
enum class FieldKind {
    Flag, Number, Integer, Text,
    Word,  // one of a fixed list of strings
    Vector,  // [x, y]
    Axis,  // "x", "y" or [x, y]
    PointPair,  // [[x, y], [x, y]]
    Points,  // [[x, y], …]
    Pairs,  // [[a, b], …]
    Triple,  // [sxx, syy, sxy]
    Place,  // position along a bolt: a number or "head"
    TextList,
    TextMap,  // {name: text}
    Object,  // {…} of the row's structure
    List,  // [{…}, …]
    Map,  // {name: {…}}
    Fixed  // without a member: only the listed values, which have no effect, are accepted
};

/// Value of a field of any kind except Object, List and Map. Words are stored as strings, integers as doubles, and null
/// as `monostate`.
using FieldValue = std::variant<std::monostate, bool, double, std::string, Point, std::vector<Point>, Table, Stress,
                                BoltPlace, std::vector<std::string>, std::map<std::string, std::string>>;

/// Valid range of a number.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool leastExcluded = false;
    bool mostExcluded = false;
};

/// Condition for a field, which refers to the field `key` of the same object: its value must be one of `words` or, if
/// `words` is empty, must not be null.
struct Only {
    std::string_view key{};
    std::vector<std::string_view> words{};  // empty: the field `key` only has to be given
};

/// A column of a table of pairs.
struct PairColumn {
    std::string_view title{};  // as shown to the user
    std::string_view unit{};  // empty: none
    std::string_view second{};  // unit of the column if the second unit of the field applies
};

struct Structure;
struct SceneCut;

/// Access to the objects in a field of kind Object, List or Map. `owner` points to the struct that contains the field's
/// member.
struct Children {
    std::size_t (*count)(const void* owner) = nullptr;  // 0 if null; otherwise 1 for an Object
    const void* (*item)(const void* owner, std::size_t index) = nullptr;
    std::string_view (*name)(const void* owner, std::size_t index) = nullptr;  // of a Map entry; empty for other kinds
    bool (*isNull)(const void* owner) = nullptr;
    void (*clear)(void* owner) = nullptr;  // to an empty List or Map; not for an Object
    void (*setNull)(void* owner) = nullptr;  // of a nullable member
    void* (*append)(void* owner, std::string_view name) = nullptr;  // pointer is valid until the next call
    void (*assign)(void* item, const void* from) = nullptr;  // copies all but the name of a Map entry
    void (*erase)(void* owner, std::size_t index) = nullptr;  // for a List or Map
    void (*move)(void* owner, std::size_t from, std::size_t to) = nullptr;  // of a List or Map
    void (*rename)(void* owner, std::size_t index, std::string_view name) = nullptr;  // for a Map
    const Structure& (*structure)() = nullptr;
};

/// One row of a field table: the description of one field.
struct Field {
    std::string_view key{};
    FieldKind kind = FieldKind::Fixed;
    std::string_view label{};  // as shown to the user; empty: derived from the key, see `labelText`
    std::string_view unit{};  // as displayed; two alternatives as `a, or b`; empty: none
    bool isModulus = false;  // elastic modulus; may be shown in GPa where stresses are shown in MPa
    bool (*takesSecond)(const void* object, const void* owner) = nullptr;  // true if the second unit applies
    std::vector<PairColumn> columns{};  // for Pairs
    std::string_view help{};
    std::string_view source{};  // source of the default; empty: chosen by this program
    Range range{};
    bool required = false;
    bool nullable = false;  // null is accepted: as a value of its own, or meaning empty
    bool emptyIsNull = false;  // null means the empty string, list or table
    bool emptyIsZero = false;  // for a Vector: [] is accepted and means zero
    bool isStress = false;  // rock stress, tension positive; may be shown with the opposite sign
    Only only{};
    std::span<const std::string_view> words{};  // of a Word; or all strings that a TextList may contain
    std::span<const std::string_view> wordLabels{};  // labels of `words` shown to the user; empty: the words themselves
    std::vector<std::string_view> laterWords{};  // words of the format that this version does not support
    std::vector<FieldValue> accepted{};  // values accepted for Fixed
    std::vector<std::string_view> names{};  // lists of the scene whose entries a Text or TextList refers to by name
    bool namesSingleBolts = false;  // refers to single bolts `P1.1`, `P1.2`, … of a pattern, not to the pattern
    std::string_view heading{};  // of its group of fields in a form; empty: the name of the structure
    bool isRare = false;  // rarely changed: initially collapsed in the form of the whole scene
    bool isSentence = false;  // a Text that may contain several words
    bool isOrdered = false;  // a List whose order the user can change
    /// Returns the value that the program uses if the field is null; null if that value is known only during a run.
    /// \param cut the result of cutting the scene; null if the scene has not been cut.
    FieldValue (*automatic)(const Scene& scene, const SceneCut* cut, const void* object) = nullptr;
    std::string_view nullText{};  // text for null if null does not stand for a number, e.g. `unlimited`
    FieldValue (*get)(const void* owner) = nullptr;
    void (*set)(void* owner, const FieldValue& value) = nullptr;  // `value` must hold the type of the member, or null
    Children children{};  // for Object, List and Map
};

/// Field table of one struct.
struct Structure {
    std::string_view name{};  // in the schema and as a heading, e.g. "joint material"
    std::string_view help{};
    const void* defaults = nullptr;  // default-constructed object of the struct
    std::vector<Field> fields{};
};

/// Field table of the scene, the root of all other tables.
const Structure& sceneStructure();

/// Field table of a bolt type. The reader resolves `like` separately.
const Structure& boltTypeStructure();

/// The scene's table and all tables below it. Each table is listed once, in depth-first order of the rows that refer to
/// it.
std::vector<const Structure*> allStructures();

/// The row with this key; null if there is none.
const Field* findField(const Structure& structure, std::string_view key);

/// True for Object, List and Map.
bool hasChildren(const Field& field);

/// True for the field that holds the name of its object.
bool isName(const Field& field);

/// True for a Map, or for a List of objects that have a name.
bool hasNames(const Field& field);

/// `field.label` or, if that is empty, a label made from the key, e.g. `Trace length` from `trace_length`.
std::string labelText(const Field& field);

/// Label of one of the field's words as shown to the user, e.g. `clockwise` for `cw`; the word itself if it has no
/// label.
std::string_view wordLabel(const Field& field, std::string_view word);

/// The automatic value from `field.automatic`; null if the field has no automatic value, or if the value is known only
/// during a run.
FieldValue automaticOf(const Field& field, const Scene& scene, const SceneCut* cut, const void* object);

/// Unit of the field in `object`. If `field.unit` has two alternatives, this is the one that applies to `object`.
/// \param owner the object whose list or member contains `object`; null if it is not known.
std::string_view unitIn(const Field& field, const void* object, const void* owner);

/// Unit of a column of a Pairs field in `object`: `column.second` if the second unit of the field applies to `object`,
/// otherwise `column.unit`.
/// \param owner the object whose list or member contains `object`; null if it is not known.
std::string_view unitIn(const Field& field, const PairColumn& column, const void* object, const void* owner);

/// Value of the field if its key is missing in the file; null for Object, List and Map.
FieldValue defaultOf(const Structure& structure, const Field& field);

/// True if the other fields of `object` meet the condition `field.only`, or if the field has no condition.
bool applies(const Structure& structure, const Field& field, const void* object);

/// True if the field has the same value in the objects `a` and `b`. Nested objects are compared too.
bool sameValue(const Field& field, const void* a, const void* b);

/// Text of the condition `field.only`, e.g. `where 'kind' is 'dynamic'`. \pre `field.only` is not empty.
std::string condition(const Field& field);

/// Error message for a field whose condition is not met, e.g. `'duration' is allowed only where 'kind' is 'dynamic'`.
std::string misplaced(const Field& field);

/// True if no number in the value is infinite or NaN.
bool isFinite(const FieldValue& value);

/// True if the range includes the number.
bool contains(const Range& range, double number);

/// The range as text, e.g. `> 0` or `≥ 0, < 90`; empty if it is unlimited.
std::string rangeText(const Range& range);

}  // namespace keyblock
