// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_palette.h"

#include "ui/look/theme.h"

#include <QAction>
#include <QPainter>
#include <QToolButton>
#include <QVariant>

namespace keyblock {
namespace {

constexpr int separatorHeight = 7, rim = 4, between = 2;  // [px]
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
    : QWidget(parent), themes_(themes) {
    setObjectName("toolPalette");
    setAccessibleName(tr("Tools"));
    setFixedWidth(paletteWidth);
    connect(&themes, &Themes::changed, this, qOverload<>(&QWidget::update));
}

void ToolPalette::add(QAction* action, const QString& name) {
    auto* button = new PaletteButton(action, themes_, this);
    button->setObjectName("palette." + action->objectName());
    button->setAccessibleName(name);
    button->setProperty("helpTopic", "studio#Tools/" + name);
    items_.push_back(button);
    layOut();
}

void ToolPalette::addLine() {
    auto* line = new QWidget(this);
    line->setFixedSize(buttonSize, separatorHeight);
    lines_.push_back(line);
    items_.push_back(line);
    layOut();
}

/// Places the items in columns, from the top.
void ToolPalette::layOut() {
    int x = 3, y = rim;
    for (QWidget* item : items_) {
        const bool isLine = item->height() == separatorHeight;
        if (y + item->height() + rim > height() && y > rim) {
            x += paletteWidth;
            y = rim;
        }
        item->setVisible(!isLine || y > rim);
        if (isLine && y == rim) continue;
        item->move(x, y);
        y += item->height() + between;
    }
    setFixedWidth(x - 3 + paletteWidth);
}

QSize ToolPalette::sizeHint() const {
    int tall = 2 * rim - between;
    for (const QWidget* item : items_) tall += item->height() + between;
    return {paletteWidth, tall};
}

QSize ToolPalette::minimumSizeHint() const { return {paletteWidth, 4 * buttonSize}; }

void ToolPalette::resizeEvent(QResizeEvent*) { layOut(); }

void ToolPalette::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& theme = themes_.current();
    painter.fillRect(rect(), theme.panel);
    painter.fillRect(width() - 1, 0, 1, height(), theme.separator);
    for (const QWidget* line : lines_)
        if (line->isVisible())
            painter.fillRect(line->x() + 5, line->geometry().center().y(), line->width() - 10, 1, theme.separator);
}

}  // namespace keyblock
