// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/notice_bar.h"

#include "ui/look/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVariant>

#include <algorithm>

namespace keyblock {

NoticeBar::NoticeBar(const Themes& themes, QWidget* over)
    : QFrame(over), themes_(themes), icon_(new QLabel(this)), text_(new QLabel(this)), row_(new QHBoxLayout(this)) {
    setObjectName("noticeBar");
    text_->setTextFormat(Qt::PlainText);
    row_->setContentsMargins(12, 6, 8, 6);
    row_->setSpacing(10);
    row_->addWidget(icon_);
    row_->addWidget(text_, 1);
    over->installEventFilter(this);
    const auto sign = [this] {
        icon_->setPixmap(themes_.icon("warning", themes_.current().warningFill).pixmap(16, 16));
    };
    connect(&themes, &Themes::changed, this, sign);
    sign();
    hide();
}

void NoticeBar::say(const QString& text, const std::vector<Answer>& answers) {
    for (QWidget* link : links_) link->deleteLater();
    links_.clear();
    text_->setText(text);
    for (const Answer& answer : answers) addLink(answer);
    addLink({tr("Close"), [] {}});
    show();
    raise();
    place();
}

void NoticeBar::addLink(const Answer& answer) {
    auto* link = new QPushButton(answer.text, this);
    link->setProperty("link", true);
    link->setCursor(Qt::PointingHandCursor);
    link->setAccessibleName(answer.text);
    link->setObjectName("notice." + answer.text);
    connect(link, &QPushButton::clicked, this, [this, run = answer.run] {
        hide();
        run();
    });
    row_->addWidget(link);
    links_.push_back(link);
    link->show();
}

void NoticeBar::place() {
    const int room = parentWidget()->width() - 20;
    resize(std::min(sizeHint().width(), room), sizeHint().height());
    move((parentWidget()->width() - width()) / 2, 10);
}

bool NoticeBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QFrame::eventFilter(watched, event);
}

}  // namespace keyblock
