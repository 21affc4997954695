// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a field to the object that it names: from a bolt to its type, from a block to
// its material.
#pragma once

#include "ui/panels/form_rows.h"

#include <string>

namespace keyblock {

/// True for fields whose value is the name of an object with properties of its own.
bool namesObject(const FormRow& row);

/// The name in the field of the first object; empty: none.
std::string nameOfTarget(const FormRow& row);

/// Pointer of that object, e.g. `/bolt_types/rebar-20`; empty: none.
std::string targetOf(const FormRow& row);

}  // namespace keyblock
