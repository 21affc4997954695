// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every widget is polished before it is first shown. Tooltips are labels too; their
// texts come from `asTip`.
#include "ui/look/plain_labels.h"

#include <QEvent>
#include <QLabel>

namespace keyblock {

bool PlainLabels::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Polish) return false;
    auto* label = qobject_cast<QLabel*>(watched);
    if (label && label->textFormat() == Qt::AutoText && !label->inherits("QTipLabel"))
        label->setTextFormat(Qt::PlainText);
    return false;
}

}  // namespace keyblock
