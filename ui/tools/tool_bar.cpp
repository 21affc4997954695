// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_bar.h"

#include "ui/look/theme.h"
#include "ui/tools/tool.h"
#include "ui/tools/tool_chip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace keyblock {
namespace {

constexpr int barHeight = 36, gap = 8;

/// A button that shows its key after its text. The key is in a frame, except on the primary button.
class KeyButton : public QPushButton {
public:
    KeyButton(const QString& key, bool primary, const Themes& themes, QWidget* parent)
        : QPushButton(parent), key_(key), primary_(primary), themes_(themes) {
        setFocusPolicy(Qt::NoFocus);
        setCursor(Qt::ArrowCursor);
        setFixedHeight(26);
    }

    QSize sizeHint() const override {
        return QSize(24 + QFontMetrics(textFont()).horizontalAdvance(text()) + gap + keyWidth(), 26);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& t = themes_.current();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        if (primary_) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(!isEnabled() ? t.border : isDown() ? t.accent.darker(115) : t.accent);
            painter.drawRoundedRect(rect(), 4.0, 4.0);
        }
        const QColor ink = !primary_ ? (underMouse() ? t.text : t.text2) : isEnabled() ? t.onAccent : t.panel;
        painter.setPen(ink);
        painter.setFont(textFont());
        const int at = 12 + QFontMetrics(textFont()).horizontalAdvance(text()) + gap;
        painter.drawText(QRect(12, 0, at, height()), Qt::AlignVCenter | Qt::AlignLeft, text());
        painter.setFont(keyFont());
        const QRectF frame(at - 0.5, 0.5 * height() - 8.5, keyWidth(), 17.0);
        if (!primary_) {
            painter.setPen(QPen(t.border, 1.0));
            painter.drawRoundedRect(frame, 3.0, 3.0);
            painter.setPen(t.text2);
        }
        painter.drawText(frame, Qt::AlignCenter, key_);
    }

private:
    QFont textFont() const {
        QFont font = this->font();
        font.setPixelSize(12);
        font.setWeight(primary_ ? QFont::DemiBold : QFont::Normal);
        return font;
    }
    QFont keyFont() const {
        QFont font = this->font();
        font.setPixelSize(primary_ ? 12 : 11);
        font.setWeight(QFont::Normal);
        return font;
    }
    int keyWidth() const { return QFontMetrics(keyFont()).horizontalAdvance(key_) + (primary_ ? 0 : 10); }

    QString key_;
    bool primary_;
    const Themes& themes_;
};

/// The next or previous visible chip; null if there is none.
ToolChip* beside(const std::vector<ToolChip*>& chips, const QString& id, bool forwards) {
    const auto isIt = [&](const ToolChip* chip) { return chip->id() == id; };
    auto at = std::distance(chips.begin(), std::find_if(chips.begin(), chips.end(), isIt));
    const auto count = static_cast<std::ptrdiff_t>(chips.size()), step = std::ptrdiff_t{forwards ? 1 : -1};
    for (at += step; at >= 0 && at < count; at += step)
        if (chips[at]->isVisible()) return chips[at];
    return nullptr;
}

}  // namespace

ToolBar::ToolBar(const Display& display, const Themes& themes, QWidget* parent)
    : QWidget(parent), display_(display), themes_(themes), icon_(new QLabel(this)), title_(new QLabel(this)),
      options_(new QWidget(this)), more_(new QToolButton(this)),
      cancel_(new KeyButton(tr("Esc"), false, themes, this)), commit_(new KeyButton(tr("Enter"), true, themes, this)) {
    setObjectName("toolBar");
    setFixedHeight(barHeight);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 12, 0);
    row->setSpacing(8);
    row->addWidget(icon_);
    title_->setObjectName("toolTitle");
    QFont bold = font();
    bold.setPixelSize(12);
    bold.setWeight(QFont::DemiBold);
    title_->setFont(bold);
    row->addWidget(title_);
    row->addSpacing(4);
    options_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(options_, 1);
    more_->setObjectName("toolMore");
    more_->setAccessibleName(tr("More options"));
    more_->setToolTip(tr("More options"));
    more_->setFocusPolicy(Qt::NoFocus);
    more_->hide();
    row->addWidget(more_);
    cancel_->setObjectName("toolCancel");
    cancel_->setText(tr("Cancel"));
    cancel_->setAccessibleName(tr("Cancel"));
    commit_->setObjectName("toolCommit");
    row->addWidget(cancel_);
    row->addWidget(commit_);
    connect(cancel_, &QPushButton::clicked, this, &ToolBar::cancelled);
    connect(commit_, &QPushButton::clicked, this, &ToolBar::committed);
    connect(more_, &QToolButton::clicked, this, &ToolBar::showMore);
    connect(&themes, &Themes::changed, this, &ToolBar::showIcon);
}

void ToolBar::showIcon() {
    if (tool_) icon_->setPixmap(themes_.icon(tool_->id(), themes_.current().accent).pixmap(16, 16));
    more_->setIcon(themes_.icon("more"));
    update();
}

void ToolBar::show(Tool* tool) {
    if (tool != tool_ && !chips_.empty()) {
        qDeleteAll(chips_);
        chips_.clear();
    }
    tool_ = tool;
    showIcon();
    title_->setText(tool ? tool->title() : QString());
    cancel_->setVisible(tool && tool->wantsPlaces());
    const QString text = tool ? tool->commitText() : QString();
    commit_->setVisible(tool && tool->wantsPlaces());
    commit_->setText(text.isEmpty() ? tr("Place") : text);
    commit_->setAccessibleName(text.isEmpty() ? tr("Place") : text);
    commit_->setEnabled(!text.isEmpty());
    commit_->updateGeometry();
    if (tool) rebuild(*tool);
    layout()->activate();
    layOut();
}

void ToolBar::rebuild(Tool& tool) {
    std::vector<ToolField> fields = tool.fields();
    const bool same = std::equal(fields.begin(), fields.end(), chips_.begin(), chips_.end(),
                                 [](const ToolField& field, const ToolChip* chip) { return field.id == chip->id(); });
    if (same) {
        for (std::size_t i = 0; i < fields.size(); ++i) chips_[i]->refresh(std::move(fields[i]));
        return;
    }
    for (ToolChip* chip : chips_) {
        chip->hide();
        chip->deleteLater();  // deferred, because this may be called from one of them
    }
    chips_.clear();
    for (ToolField& field : fields) {
        auto* chip = new ToolChip(std::move(field), display_, themes_, options_);
        connect(chip, &ToolChip::done, this, &ToolBar::leftField);
        connect(chip, &ToolChip::passed, this, [this, id = chip->id()](bool forwards) {
            if (ToolChip* next = beside(chips_, id, forwards)) next->enter();
            else Q_EMIT leftField();
        });
        chips_.push_back(chip);
    }
}

/// Shows as many chips as fit, from the left; the others are in a popup.
void ToolBar::layOut() {
    const int forMore = more_->sizeHint().width() + layout()->spacing();
    int room = options_->width() + (more_->isVisible() ? forMore : 0), all = -gap;
    for (const ToolChip* chip : chips_) all += chip->sizeHint().width() + gap;
    if (all > room) room -= forMore;
    int at = 0;
    bool fits = true;
    for (ToolChip* chip : chips_) {
        const int width = chip->sizeHint().width();
        fits = fits && at + width <= room;
        chip->setGeometry(at, (options_->height() - chip->height()) / 2, width, chip->height());
        chip->setVisible(fits);
        at += width + gap;
    }
    more_->setVisible(!fits);
}

void ToolBar::showMore() {
    if (!tool_) return;
    auto* popup = new QFrame(this, Qt::Popup);
    popup->setObjectName("toolMorePopup");
    popup->setAttribute(Qt::WA_DeleteOnClose);
    popup->setFrameShape(QFrame::StyledPanel);
    auto* column = new QVBoxLayout(popup);
    column->setContentsMargins(gap, gap, gap, gap);
    std::vector<ToolField> fields = tool_->fields();
    std::vector<ToolChip*> further;
    for (std::size_t i = 0; i < fields.size() && i < chips_.size(); ++i) {
        if (chips_[i]->isVisible()) continue;
        auto* chip = new ToolChip(std::move(fields[i]), display_, themes_, popup);
        connect(chip, &ToolChip::done, popup, &QWidget::close);
        column->addWidget(chip);
        further.push_back(chip);
    }
    for (ToolChip* chip : further)
        connect(chip, &ToolChip::passed, popup, [further, popup, id = chip->id()](bool forwards) {
            if (ToolChip* next = beside(further, id, forwards)) next->enter();
            else popup->close();
        });
    popup->adjustSize();
    popup->move(more_->mapToGlobal(QPoint(more_->width() - popup->width(), more_->height() + 4)));
    popup->show();
}

void ToolBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    layOut();
}

void ToolBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    painter.fillRect(0, height() - 1, width(), 1, themes_.current().separator);
}

}  // namespace keyblock
