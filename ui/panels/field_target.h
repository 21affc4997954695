// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the object that a field names, e.g. the type of a bolt or the material of a
// block.
#pragma once

#include "ui/panels/form_rows.h"

#include <string>

namespace keyblock {

/// True if the value of the field is the name of an object with properties of its own.
bool namesObject(const FormRow& row);

/// The name in this field of the first object of the form; empty if it has none.
std::string nameOfTarget(const FormRow& row);

/// Pointer to the object with that name, e.g. `/bolt_types/rebar-20`; empty if there is none.
std::string targetOf(const FormRow& row);

}  // namespace keyblock
