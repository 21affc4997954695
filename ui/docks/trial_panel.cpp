// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/trial_panel.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVariant>
#include <QVBoxLayout>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int leastForTrialButton = 340;  // [px] of a panel with the button next to the text
constexpr int leastTrialContent = 72;  // [px]

/// With a capital, as texts of the solver, which start lines of the command line with a small letter.
QString asSentence(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

}  // namespace

TrialPanel::TrialPanel(const QString& key, const QString& name, const QString& start, QWidget* parent)
    : QScrollArea(parent), page_(new QWidget(this)), answer_(new QLabel(page_)), detail_(new QLabel(page_)),
      row_(new QHBoxLayout), column_(new QVBoxLayout(page_)), progress_(new QProgressBar(page_)),
      start_(new QPushButton(start, page_)), stop_(new QPushButton(tr("Stop"), page_)) {
    setObjectName(key + "Panel");
    setAccessibleName(name);
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    page_->setObjectName("trialPage");
    answer_->setObjectName(key + "Answer");
    answer_->setProperty("role", "title");
    detail_->setObjectName(key + "Detail");
    detail_->setProperty("role", "detail");
    for (QLabel* label : {answer_, detail_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    start_->setObjectName(key + ".start");
    stop_->setObjectName(key + ".stop");
    for (QPushButton* button : {start_, stop_}) {
        button->setAccessibleName(button->text());
        button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    }
    row_->addWidget(answer_, 1);
    row_->addWidget(stop_, 0, Qt::AlignTop);
    row_->addWidget(start_, 0, Qt::AlignTop);
    column_->setContentsMargins(12, 6, 12, 6);
    column_->setSpacing(4);
    column_->addLayout(row_);
    column_->addWidget(progress_);
    column_->addWidget(detail_);
    setWidget(page_);
    connect(start_, &QPushButton::clicked, this, &TrialPanel::startAsked);
    connect(stop_, &QPushButton::clicked, this, &TrialPanel::stopAsked);
}

/// The content counts with its least height only, so that the panel scrolls only where that has no room.
void TrialPanel::setContent(QWidget* content) {
    content->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    content->setMinimumHeight(std::max(leastTrialContent, content->minimumHeight()));
    column_->addWidget(content, 1);
}

void TrialPanel::keepDetailLine() {
    keepsDetail_ = true;
    detail_->setMinimumHeight(detail_->fontMetrics().lineSpacing());
}

void TrialPanel::present(bool busy, double fraction, const QString& answer, const QString& detail) {
    start_->setVisible(!busy);
    stop_->setVisible(busy);
    progress_->setVisible(busy);
    progress_->setValue(static_cast<int>(100.0 * fraction));
    answer_->setText(asSentence(answer));
    detail_->setText(detail);
    detail_->setVisible(keepsDetail_ || !detail.isEmpty());
    arrange();
}

void TrialPanel::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrange();
}

/// The button is below the text where there is little room next to it. The height that the wrapped texts then need is a
/// least height of the page; a layout alone would clip them.
void TrialPanel::arrange() {
    const int width = viewport()->width();
    row_->setDirection(width < leastForTrialButton ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    row_->invalidate();  // it keeps the height for the text before
    column_->invalidate();
    page_->setMinimumHeight(column_->hasHeightForWidth() ? column_->minimumHeightForWidth(width)
                                                         : column_->minimumSize().height());
}

}  // namespace keyblock
