// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Help on a field, shown at the bottom of a panel: name, range, default, help text and
// source.
#pragma once

#include "ui/panels/editors/value_editor.h"

#include <QString>

#include <string_view>

namespace keyblock {

struct FieldHelp {
    QString name;
    QString numbers;  // e.g. `0 … 2 000 kN/m · default 736.8`
    QString text;
};

FieldHelp helpOf(const FormRow& row, const FormContext& context);

/// Error message for a value out of range, in display units; empty if the value is in range.
QString outOfRange(const FormRow& row, const FieldValue& value, const FormContext& context);

/// The help text of a field without the markup of the reference page; "null" is replaced by "automatic".
QString plainHelp(std::string_view help);

}  // namespace keyblock
