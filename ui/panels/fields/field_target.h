// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the object that a field names, e.g. the type of a bolt or the material of a
// block.
#pragma once

#include "ui/panels/fields/form_rows.h"

#include <string>

namespace keyblock {

/// True if the value of the field is the name of an object that has properties of its own.
bool namesObject(const FormRow& row);

/// The name that the field contains, for the first object of the form; empty if the field is empty.
std::string nameOfTarget(const FormRow& row);

/// Pointer to the object named by the field, e.g. `/bolt_types/rebar-20`; empty if the field names none.
std::string targetOf(const FormRow& row);

}  // namespace keyblock
