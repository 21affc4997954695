// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/search_box.h"

#include "ui/look/theme.h"

#include <QAction>
#include <QPainter>

namespace keyblock {

SearchBox::SearchBox(QAction& command, const Themes& themes, QWidget* parent)
    : QAbstractButton(parent), command_(command), themes_(themes) {
    setObjectName("searchBox");
    setText(tr("Search commands"));
    setAccessibleName(text());
    setToolTip(command.toolTip());
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setFixedSize(sizeHint());
    connect(this, &QAbstractButton::clicked, &command, &QAction::trigger);
    connect(&command, &QAction::changed, this, qOverload<>(&QWidget::update));
    connect(&themes, &Themes::changed, this, qOverload<>(&QWidget::update));
}

void SearchBox::paintEvent(QPaintEvent*) {
    const Theme& t = themes_.current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? t.accent : underMouse() ? t.text3 : t.border, hasFocus() ? 2 : 1));
    painter.setBrush(t.field);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    themes_.icon("search", t.text3).paint(&painter, QRect(9, 5, 13, 13));
    const QString keys = command_.shortcut().toString(QKeySequence::NativeText);
    QFont small = font();
    small.setPixelSize(10);
    const int keysWidth = QFontMetrics(small).horizontalAdvance(keys) + 10;
    painter.setPen(t.text3);
    painter.drawText(QRect(28, 0, width() - 40 - keysWidth, height()), Qt::AlignVCenter | Qt::AlignLeft, text());
    if (keys.isEmpty()) return;
    const QRectF chip(width() - keysWidth - 4.5, 4.5, keysWidth, height() - 9);
    painter.setPen(t.border);
    painter.setBrush(t.header);
    painter.drawRoundedRect(chip, 3, 3);
    painter.setFont(small);
    painter.setPen(t.text2);
    painter.drawText(chip, Qt::AlignCenter, keys);
}

}  // namespace keyblock
