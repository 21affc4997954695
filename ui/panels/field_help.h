// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the foot of a panel says of a field: name, range, default, help, source.
#pragma once

#include "ui/panels/value_editor.h"

#include <QString>

#include <string_view>

namespace keyblock {

struct FieldHelp {
    QString name;
    QString numbers;  // `0 … 2 000 kN/m · default 736.8`
    QString text;
};

FieldHelp helpOf(const FormRow& row, const FormContext& context);

/// Why the value cannot stand in the field, in the units shown; empty where its numbers are in range.
QString outOfRange(const FormRow& row, const FieldValue& value, const FormContext& context);

/// A help text of the table without the marks of the reference page; null is called automatic.
QString plainHelp(std::string_view help);

}  // namespace keyblock
