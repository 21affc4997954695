// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/gallery.h"

#include "ui/look/elided_label.h"
#include "ui/look/theme.h"
#include "ui/start/start_buttons.h"
#include "ui/start/thumbnails.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVariant>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr int galleryGap = 28, galleryRim = 44, foot = 28, leastForTitle = 560;  // [px]
constexpr QSize pictureSize(500, SampleCard::picture);  // wider than a card, which shows only the middle

struct Kind {
    const char* text;
    bool (*has)(const Sample& sample);
};

const std::array kindsOfSamples{
    Kind{QT_TRANSLATE_NOOP("keyblock::Gallery", "All"), [](const Sample&) { return true; }},
    Kind{QT_TRANSLATE_NOOP("keyblock::Gallery", "Drifts"), [](const Sample& s) { return s.category == "drifts"; }},
    Kind{QT_TRANSLATE_NOOP("keyblock::Gallery", "Bolts"), [](const Sample& s) { return s.category == "bolts"; }},
    Kind{QT_TRANSLATE_NOOP("keyblock::Gallery", "Blocks"), [](const Sample& s) { return s.category == "blocks"; }},
    Kind{QT_TRANSLATE_NOOP("keyblock::Gallery", "Dynamic"), [](const Sample& s) { return s.isDynamic; }},
    Kind{QT_TRANSLATE_NOOP("keyblock::Gallery", "Verification"), [](const Sample& s) { return s.isVerification; }},
};

}  // namespace

Gallery::Gallery(const Themes& themes, Thumbnails& thumbnails, QWidget* parent)
    : QWidget(parent), themes_(themes), thumbnails_(thumbnails), samples_(gallerySamples()),
      kinds_(new QButtonGroup(this)), scroll_(new QScrollArea(this)), sheet_(new QWidget) {
    setObjectName("gallery");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 24, 0, 0);
    column->setSpacing(16);
    column->addWidget(makeHeader());
    column->addWidget(scroll_, 1);
    makeCards();
    sheet_->setObjectName("gallerySheet");
    scroll_->setObjectName("galleryScroll");
    scroll_->setWidget(sheet_);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    connect(kinds_, qOverload<int, bool>(&QButtonGroup::idToggled), this, [this](int, bool on) { if (on) place(); });
    connect(&thumbnails_, &Thumbnails::ready, this, [this](const QString& path, QSize size, const QImage& image) {
        for (std::size_t i = 0; i < samples_.size(); ++i)
            if (samples_[i].path == path && size == pictureSize) cards_[i]->setPicture(image);
    });
    connect(&themes_, &Themes::changed, this, [this] {
        asked_ = 0.0;
        askForPictures();
    });
}

QWidget* Gallery::makeHeader() {
    auto* header = new QWidget(this);
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(galleryRim, 0, galleryRim, 0);
    row->setSpacing(4);
    auto* title = new QLabel(tr("Samples"), header);
    title->setObjectName("sectionTitle");
    auto* hint = new ElidedLabel(header);
    hint->setText(tr("Each opens as a copy, with expected results"));
    hint->setObjectName("hint");
    hint->setMinimumWidth(0);
    hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    title_ = title;
    hint_ = hint;
    row->addWidget(title);
    row->addSpacing(8);
    row->addWidget(hint, 1);
    row->addSpacing(8);
    for (std::size_t i = 0; i < kindsOfSamples.size(); ++i) {
        const auto n = std::ranges::count_if(samples_, kindsOfSamples[i].has);
        auto* pill = new QPushButton(tr(kindsOfSamples[i].text) + (i == 0 ? " " + QString::number(n) : QString()), header);
        pill->setCheckable(true);
        pill->setAutoDefault(true);  // Enter presses it, as Space does
        pill->setChecked(i == 0);
        pill->setProperty("pill", true);
        pill->setObjectName(QStringLiteral("kind.") + kindsOfSamples[i].text);
        pill->setAccessibleName(tr("Show samples: %1").arg(tr(kindsOfSamples[i].text)));
        pill->setToolTip(n == 1 ? tr("1 sample") : tr("%1 samples").arg(n));
        kinds_->addButton(pill, static_cast<int>(i));
        row->addWidget(pill);
    }
    return header;
}

void Gallery::makeCards() {
    for (const Sample& sample : samples_) {
        auto* card = new SampleCard(sample, themes_, sheet_);
        card->installEventFilter(this);
        connect(card, &SampleCard::clicked, this, [this, sample] { Q_EMIT wanted(sample); });
        cards_.push_back(card);
    }
}

bool Gallery::isShown(const Sample& sample) const {
    const int kind = std::max(0, kinds_->checkedId());
    return kindsOfSamples[static_cast<std::size_t>(kind)].has(sample);
}

void Gallery::place() {
    const int room = scroll_->viewport()->width() - 2 * galleryRim;
    columns_ = std::max(1, (room + galleryGap) / (SampleCard::leastWidth + galleryGap));
    const int width = std::max(SampleCard::leastWidth, (room - (columns_ - 1) * galleryGap) / columns_);
    int shown = 0;
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        cards_[i]->setVisible(isShown(samples_[i]));
        if (!isShown(samples_[i])) continue;
        cards_[i]->setGeometry(galleryRim + shown % columns_ * (width + galleryGap),
                               shown / columns_ * (SampleCard::height + galleryGap) + 1, width, SampleCard::height);
        ++shown;
    }
    const int rows = (shown + columns_ - 1) / columns_;
    sheet_->resize(scroll_->viewport()->width(), rows * (SampleCard::height + galleryGap) - galleryGap + foot);
    askForPictures();
}

void Gallery::askForPictures() {
    if (!isVisible()) return;
    const double ratio = devicePixelRatioF();
    if (asked_ == ratio) return;
    asked_ = ratio;
    for (const Sample& sample : samples_) thumbnails_.ask(sample.path, pictureSize, ratio, themes_.current());
}

void Gallery::resizeEvent(QResizeEvent* event) {
    for (QWidget* words : {title_, hint_}) words->setVisible(width() >= leastForTitle);
    QWidget::resizeEvent(event);
    QMetaObject::invokeMethod(this, [this] { place(); }, Qt::QueuedConnection);  // after the scroll area has its size
}

bool Gallery::eventFilter(QObject* watched, QEvent* event) {
    auto* card = qobject_cast<SampleCard*>(watched);
    if (card && event->type() == QEvent::FocusIn) scroll_->ensureWidgetVisible(card, 0, galleryGap);
    if (!card || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        card->click();
        return true;
    }
    if (key != Qt::Key_Left && key != Qt::Key_Right && key != Qt::Key_Up && key != Qt::Key_Down) return false;
    step(card, columns_, key);
    return true;
}

/// Moves the focus from card to card with the arrow keys, among the visible cards.
void Gallery::step(SampleCard* from, int columns, int key) {
    std::vector<SampleCard*> shown;
    std::ranges::copy_if(cards_, std::back_inserter(shown), [](SampleCard* card) { return !card->isHidden(); });
    const auto at = static_cast<int>(std::ranges::find(shown, from) - shown.begin());
    const int by = key == Qt::Key_Left ? -1 : key == Qt::Key_Right ? 1 : key == Qt::Key_Up ? -columns : columns;
    if (at + by >= 0 && at + by < static_cast<int>(shown.size())) shown[at + by]->setFocus(Qt::TabFocusReason);
}

}  // namespace keyblock
