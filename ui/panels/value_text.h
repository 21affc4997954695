// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of fields as a person reads and types them: in the units shown, sums and
// units allowed, `head` for the head of a bolt. The scene keeps SI.
#pragma once

#include "solver/scene/field.h"

#include <QString>

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

class Display;

/// A number of that SI unit as shown; \p digits significant ones at most.
QString numberText(double value, std::string_view unit, const Display& display, int digits = 6);

/// The same, such that it reads back to the last bit, for a field that is being edited.
QString exactNumberText(double value, std::string_view unit, const Display& display);

/// What was typed, or what is wrong with it.
template <typename Value>
struct Typed {
    std::optional<Value> value;
    QString problem;
};

/// Reads a number typed in the unit shown, with another unit behind it, or as a sum. [SI]
Typed<double> readNumber(const QString& text, std::string_view unit, const Display& display);

/// Text of a value on one line: numbers, places, points and triples; texts as they are. Nothing for null.
QString valueText(const FieldValue& value, const Field& field, std::string_view unit, const Display& display,
                  bool exact = false);

/// Reads such a text. An empty one is null where the field may be null.
Typed<FieldValue> readValue(const QString& text, const Field& field, std::string_view unit, const Display& display);

/// One line that stands for any value: `5 points`, `(0, 0) … (1, 0.004)`.
QString summaryOf(const FieldValue& value, const Field& field, std::string_view unit, const Display& display);

}  // namespace keyblock
