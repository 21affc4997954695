// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts field values to and from text: in display units, with expressions and unit
// suffixes, and with `head` for the head of a bolt. The scene keeps SI units.
#pragma once

#include "solver/scene/field.h"

#include <QString>

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

class Display;

/// Text of a number in the display unit, with at most `digits` significant digits. \param value the number in the SI
/// unit `unit`
QString numberText(double value, std::string_view unit, const Display& display, int digits = 6);

/// Like `numberText`, with enough digits to restore the number exactly, for a field that is being edited.
QString exactNumberText(double value, std::string_view unit, const Display& display);

/// The value that the user typed, or an error message.
template <typename Value>
struct Typed {
    std::optional<Value> value;
    QString problem;
};

/// Reads a number that is typed in the display unit, with another unit, or as an expression. Returns the number in the
/// SI unit `unit`.
Typed<double> readNumber(const QString& text, std::string_view unit, const Display& display);

/// Text of a value that fits on one line (number, position, point, triple or string), in display units. Empty if the
/// value is null.
/// \param exact true: numbers have enough digits to be restored exactly.
QString valueText(const FieldValue& value, const Field& field, std::string_view unit, const Display& display,
                  bool exact = false);

/// Parses text in the format of `valueText`. Empty text gives null if the field may be null.
Typed<FieldValue> readValue(const QString& text, const Field& field, std::string_view unit, const Display& display);

/// A one-line summary of any value: `5 points`, `yes`.
QString summaryOf(const FieldValue& value, const Field& field, std::string_view unit, const Display& display);

}  // namespace keyblock
