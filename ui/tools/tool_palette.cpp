// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_palette.h"

#include "ui/look/theme.h"

#include <QAction>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

namespace keyblock {
namespace {

constexpr int paletteWidth = 44, buttonSize = 36, iconPixels = 18, letterPixels = 9;

/// A button with the letter of its key in the corner.
class PaletteButton : public QToolButton {
public:
    PaletteButton(QAction* action, const Themes& themes, QWidget* parent) : QToolButton(parent), themes_(themes) {
        setDefaultAction(action);
        setFixedSize(buttonSize, buttonSize);
        setIconSize(QSize(iconPixels, iconPixels));
        setToolButtonStyle(Qt::ToolButtonIconOnly);
        setFocusPolicy(Qt::NoFocus);
    }

protected:
    void paintEvent(QPaintEvent* event) override {
        QToolButton::paintEvent(event);
        const QString key = defaultAction()->shortcut().toString(QKeySequence::NativeText);
        if (key.size() != 1) return;
        QPainter painter(this);
        QFont font = painter.font();
        font.setPixelSize(letterPixels);
        painter.setFont(font);
        painter.setPen(isChecked() ? themes_.current().accent : themes_.current().text3);
        painter.drawText(rect().adjusted(0, 0, -4, -2), Qt::AlignRight | Qt::AlignBottom, key);
    }

private:
    const Themes& themes_;
};

}  // namespace

ToolPalette::ToolPalette(const Themes& themes, QWidget* parent)
    : QWidget(parent), themes_(themes), column_(new QVBoxLayout(this)) {
    setObjectName("toolPalette");
    setAccessibleName(tr("Tools"));
    setFixedWidth(paletteWidth);
    column_->setContentsMargins(3, 4, 4, 4);
    column_->setSpacing(2);
    column_->addStretch();
    connect(&themes, &Themes::changed, this, qOverload<>(&QWidget::update));
}

void ToolPalette::add(QAction* action, const QString& name) {
    auto* button = new PaletteButton(action, themes_, this);
    button->setObjectName("palette." + action->objectName());
    button->setAccessibleName(name);
    button->setProperty("helpTopic", "studio#Tools/" + name);
    column_->insertWidget(column_->count() - 1, button);
}

void ToolPalette::addLine() {
    auto* line = new QWidget(this);
    line->setFixedHeight(7);
    lines_.push_back(line);
    column_->insertWidget(column_->count() - 1, line);
}

QSize ToolPalette::sizeHint() const { return {paletteWidth, QWidget::sizeHint().height()}; }

void ToolPalette::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& theme = themes_.current();
    painter.fillRect(rect(), theme.panel);
    painter.fillRect(width() - 1, 0, 1, height(), theme.separator);
    for (const QWidget* line : lines_) painter.fillRect(8, line->geometry().center().y(), width() - 17, 1, theme.separator);
}

}  // namespace keyblock
