// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help on a field at the bottom of a panel: name, range, default, help text,
// source.
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

/// Why the value is out of range, in the units shown; empty if it is in range.
QString outOfRange(const FormRow& row, const FieldValue& value, const FormContext& context);

/// A help text of the field table without the markup of the reference page; "null" becomes "automatic".
QString plainHelp(std::string_view help);

}  // namespace keyblock
