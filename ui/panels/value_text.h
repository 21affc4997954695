// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of fields as they are displayed and typed: in the units shown, with
// expressions and units, `head` for the head of a bolt. The scene keeps SI.
#pragma once

#include "solver/scene/field.h"

#include <QString>

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

class Display;

/// A number of that SI unit as shown, with at most \p digits significant digits.
QString numberText(double value, std::string_view unit, const Display& display, int digits = 6);

/// The same with enough digits to read back exactly, for a field that is being edited.
QString exactNumberText(double value, std::string_view unit, const Display& display);

/// The value typed, or what is wrong with it.
template <typename Value>
struct Typed {
    std::optional<Value> value;
    QString problem;
};

/// Reads a number typed in the unit shown, with another unit, or as an expression. [SI]
Typed<double> readNumber(const QString& text, std::string_view unit, const Display& display);

/// Text of a value on one line: numbers, positions, points, triples and texts. Empty for null.
QString valueText(const FieldValue& value, const Field& field, std::string_view unit, const Display& display,
                  bool exact = false);

/// Reads such a text. An empty one is null if the field may be null.
Typed<FieldValue> readValue(const QString& text, const Field& field, std::string_view unit, const Display& display);

/// A one-line summary of any value: `5 points`, `yes`.
QString summaryOf(const FieldValue& value, const Field& field, std::string_view unit, const Display& display);

}  // namespace keyblock
