// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/selection.h"

#include "ui/document/document.h"

namespace keyblock {

QStringList whereNow(const QStringList& pointers, const WhereNow& now) {
    QStringList left;
    for (const QString& pointer : pointers)
        if (const auto at = now(pointer.toStdString())) left << QString::fromStdString(*at);
    return left;
}

void Selection::follow(const Document& document) {
    connect(&document, &Document::moved, this, [this](const WhereNow& now) { set(whereNow(pointers_, now)); });
    connect(&document, &Document::replaced, this, &Selection::clear);
}

}  // namespace keyblock
