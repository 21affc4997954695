// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names chosen by the user may contain characters that Qt interprets, such as `<b>` in
// a tooltip or `&` in a menu. These functions escape them, so that they appear as
// typed.
#pragma once

#include <QString>
#include <QTextDocument>

namespace keyblock {

inline QString asTip(const QString& text) {
    if (!Qt::mightBeRichText(text)) return text;
    return QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped().replace('\n', QStringLiteral("<br>")));
}

inline QString asMenuText(QString text) { return text.replace('&', QStringLiteral("&&")); }

}  // namespace keyblock
