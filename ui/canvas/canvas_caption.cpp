// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_caption.h"

#include "ui/canvas/canvas.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace keyblock {

CanvasCaption::CanvasCaption(Canvas& canvas, const Themes& themes, bool canClose)
    : QFrame(&canvas), themes_(themes), text_(new QLabel(this)) {
    setObjectName("canvasCaption");
    setCursor(Qt::ArrowCursor);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 4, canClose ? 4 : 10, 4);
    row->setSpacing(6);
    text_->setObjectName("canvasCaptionText");
    text_->setTextFormat(Qt::PlainText);
    row->addWidget(text_);
    setMinimumHeight(30);  // same height with and without the button
    if (canClose) {
        close_ = new QToolButton(this);
        close_->setObjectName("endComparing");
        close_->setAccessibleName(tr("Close the comparison"));
        close_->setToolTip(close_->accessibleName());
        close_->setFixedSize(20, 20);
        row->addWidget(close_);
        connect(close_, &QToolButton::clicked, this, &CanvasCaption::closed);
    }
    connect(&themes, &Themes::changed, this, &CanvasCaption::showTheme);
    showTheme();
}

void CanvasCaption::setText(const QString& text) {
    constexpr int most = 320;  // [px]
    text_->setText(text_->fontMetrics().elidedText(text, Qt::ElideMiddle, most));
    text_->setToolTip(asTip(text));
    adjustSize();
    move(10, 10);
    raise();
    show();
}

void CanvasCaption::showTheme() {
    const Theme& theme = themes_.current();
    setStyleSheet(QStringLiteral("#canvasCaption { background: %1; border: 1px solid %2; border-radius: 4px; }"
                                 "#canvasCaptionText { background: transparent; color: %3; font-weight: 600; }")
                      .arg(theme.panel.name(), theme.border.name(), theme.text.name()));
    if (close_) close_->setIcon(themes_.icon("close"));
}

}  // namespace keyblock
