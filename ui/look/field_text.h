// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of the field table, translated to the language of the window.
#pragma once

#include "solver/scene/field.h"

#include <QString>

#include <string_view>

namespace keyblock {

/// Translation of a text that the solver has marked with `translatable`.
QString shownText(std::string_view text);

/// Label of one of the fixed choices of a field, e.g. `clockwise` for `cw`.
QString choiceText(const Field& field, std::string_view word);

}  // namespace keyblock
