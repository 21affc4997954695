// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads and changes single values of a study by JSON pointer, using the field table.
#pragma once

#include "solver/scene/field.h"
#include "solver/study/study.h"

#include <QString>

#include <optional>
#include <string>

namespace keyblock {

/// A field of a study and the struct that contains it.
struct StudyPlace {
    const Structure* structure = nullptr;
    const Field* field = nullptr;
    const void* owner = nullptr;

    FieldValue value() const { return field->get(owner); }
    /// Whether the field applies to the other values of its struct, e.g. the mean to a normal distribution.
    bool isUsed() const { return applies(*structure, *field, owner); }
};

/// The field at a pointer such as `/parameters/0/distribution/mean`; none if the study has no such value.
std::optional<StudyPlace> placeAt(const Study& study, const std::string& pointer);

/// Sets a value. \pre `placeAt` finds the field, and the value has its type
void setValue(Study& study, const std::string& pointer, const FieldValue& value);

/// A value as it is typed: numbers with all digits, items of lists separated by commas, nothing for null.
QString typedText(const StudyPlace& place);

struct TypedValue {
    std::optional<FieldValue> value;
    QString problem;  // why the text is not a value of the field; empty if it is
};

/// Reads what was typed into a field.
TypedValue typedValue(const StudyPlace& place, const QString& text);

}  // namespace keyblock
