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
#include <QScrollArea>
#include <QVariant>

#include <algorithm>

namespace keyblock {
namespace {

constexpr int barHeight = 36;

/// Options that find no room scroll, so that the buttons at the end stay in sight.
QScrollArea* scrolled(QWidget* content, QWidget* parent) {
    auto* area = new QScrollArea(parent);
    area->setObjectName("toolOptions");
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    area->setFixedHeight(barHeight - 2);
    return area;
}

QPushButton* button(QWidget* parent, const char* name) {
    auto* made = new QPushButton(parent);
    made->setObjectName(name);
    made->setFocusPolicy(Qt::NoFocus);
    return made;
}

}  // namespace

ToolBar::ToolBar(const Display& display, const Themes& themes, QWidget* parent)
    : QWidget(parent), display_(display), themes_(themes), icon_(new QLabel(this)), title_(new QLabel(this)),
      cancel_(button(this, "toolCancel")), commit_(button(this, "toolCommit")) {
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
    auto* content = new QWidget(this);
    content->setObjectName("toolOptionsContent");
    options_ = new QHBoxLayout(content);
    options_->setContentsMargins(0, 0, 0, 0);
    options_->setSpacing(8);
    options_->addStretch();
    row->addWidget(scrolled(content, this), 1);
    cancel_->setFlat(true);
    cancel_->setText(tr("Cancel  Esc"));
    cancel_->setAccessibleName(tr("Cancel"));
    commit_->setProperty("primary", true);
    row->addWidget(cancel_);
    row->addWidget(commit_);
    connect(cancel_, &QPushButton::clicked, this, &ToolBar::cancelled);
    connect(commit_, &QPushButton::clicked, this, &ToolBar::committed);
    connect(&themes, &Themes::changed, this, &ToolBar::showIcon);
}

void ToolBar::showIcon() {
    if (tool_) icon_->setPixmap(themes_.icon(tool_->id(), themes_.current().accent).pixmap(16, 16));
    const Theme& t = themes_.current();
    setStyleSheet(QString("#toolOptions, #toolOptionsContent { background: transparent; }"
                          "#toolCancel { border: none; background: transparent; color: %1; }"
                          "#toolCancel:hover { color: %2; }").arg(t.text2.name(), t.text.name()));
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
    commit_->setText((text.isEmpty() ? tr("Place") : text) + tr("  Enter"));
    commit_->setAccessibleName(text.isEmpty() ? tr("Place") : text);
    commit_->setEnabled(!text.isEmpty());
    if (tool) rebuild(*tool);
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
        chip->deleteLater();  // one of them may be what a person just used
    }
    chips_.clear();
    for (ToolField& field : fields) {
        auto* chip = new ToolChip(std::move(field), display_, themes_, this);
        options_->insertWidget(options_->count() - 1, chip);
        connect(chip, &ToolChip::done, this, &ToolBar::leftField);
        chip->show();
        chips_.push_back(chip);
    }
}

void ToolBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    painter.fillRect(0, height() - 1, width(), 1, themes_.current().separator);
}

}  // namespace keyblock
