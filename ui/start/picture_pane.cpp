// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/picture_pane.h"

#include "ui/look/theme.h"
#include "ui/start/thumbnail.h"

#include <QPainter>

namespace keyblock {

PicturePane::PicturePane(const Themes& themes, QWidget* parent) : QWidget(parent), themes_(themes) {
    setMinimumSize(240, 180);
    connect(&themes, &Themes::changed, this, qOverload<>(&QWidget::update));
}

void PicturePane::show(std::optional<SectionPicture> picture, const QString& otherwise) {
    picture_ = std::move(picture);
    otherwise_ = otherwise;
    setAccessibleDescription(picture_ ? QString() : otherwise);
    update();
}

void PicturePane::paintEvent(QPaintEvent*) {
    const Theme& t = themes_.current();
    QPainter painter(this);
    painter.fillRect(rect(), t.canvas);
    const double ratio = devicePixelRatioF();
    if (picture_)
        painter.drawImage(0, 0, paintThumbnail(*picture_, (QSizeF(size()) * ratio).toSize(), ratio, t,
                                               ThumbnailView::Everything));
    painter.setPen(t.separator);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.setPen(t.text2);
    if (!picture_) painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, otherwise_);
}

}  // namespace keyblock
