// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// User-defined names may contain characters that Qt interprets: `<b>` in a tooltip,
// `&` in a menu. These functions make them appear as written.
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
