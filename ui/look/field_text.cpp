// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// These texts are marked with translatable("Fields", …) in the solver, where lupdate
// finds them.
#include "ui/look/field_text.h"

#include <QCoreApplication>

#include <string>

namespace keyblock {

QString shownText(std::string_view text) { return QCoreApplication::translate("Fields", std::string(text).c_str()); }

QString choiceText(const Field& field, std::string_view word) {
    const std::string_view label = wordLabel(field, word);
    if (!field.wordLabels.empty()) return shownText(label);
    return QString::fromUtf8(label.data(), static_cast<int>(label.size()));
}

}  // namespace keyblock
