// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/mode_line.h"

#include "ui/look/commands.h"
#include "ui/look/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QPainter>

namespace keyblock {
namespace {

constexpr int lineHeight = 20, boxSize = 9, modeGap = 6;

/// A switch that shows a small box, the name of the mode, and its key in a frame.
class ModeSwitch : public QAbstractButton {
public:
    ModeSwitch(QAction* action, const Themes& themes, QWidget* parent) : QAbstractButton(parent), action_(action), themes_(themes) {
        setCheckable(true);
        setFocusPolicy(Qt::NoFocus);
        setObjectName("mode." + action->objectName());
        setAccessibleName(action->text());
        QFont small = font();
        small.setPixelSize(11);
        setFont(small);
        const auto show = [this] {
            setChecked(action_->isChecked());
            setToolTip(action_->toolTip());
            updateGeometry();  // its shortcut may have changed
        };
        QObject::connect(action, &QAction::changed, this, show);
        QObject::connect(this, &QAbstractButton::clicked, action, [this, action] {
            setChecked(action->isChecked());
            action->trigger();
        });
        show();
    }

    QSize sizeHint() const override {
        return {boxSize + 3 * modeGap + fontMetrics().horizontalAdvance(action_->text()) + keyWidth() + 6, lineHeight};
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& t = themes_.current();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const double middle = 0.5 * QWidget::height();
        painter.setPen(QPen(isChecked() ? t.accent : t.text3, 1.2));
        painter.setBrush(isChecked() ? QBrush(t.accent) : QBrush(Qt::NoBrush));
        painter.drawRoundedRect(QRectF(3.5, middle - 0.5 * boxSize, boxSize, boxSize), 2.0, 2.0);
        painter.setPen(isChecked() ? t.text : t.text2);
        const int at = 3 + boxSize + modeGap;
        painter.drawText(QRect(at, 0, width(), QWidget::height()), Qt::AlignVCenter | Qt::AlignLeft, action_->text());
        const int keyAt = at + fontMetrics().horizontalAdvance(action_->text()) + modeGap;
        const QRectF frame(keyAt + 0.5, middle - 7.5, keyWidth(), 15.0);
        painter.setPen(QPen(t.border, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(frame, 3.0, 3.0);
        painter.setPen(t.text2);
        painter.drawText(frame, Qt::AlignCenter, key());
    }

private:
    QString key() const { return keysOf(*action_); }
    int keyWidth() const { return fontMetrics().horizontalAdvance(key()) + 8; }

    QAction* action_;
    const Themes& themes_;
};

}  // namespace

ModeLine::ModeLine(const Commands& commands, const Themes& themes, QWidget* parent) : QWidget(parent) {
    setObjectName("modeLine");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 6, 0);
    row->setSpacing(8);
    for (const char* id : {"draw.objectSnap", "draw.ortho", "draw.gridSnap"})
        row->addWidget(new ModeSwitch(commands.action(id), themes, this));
    connect(&themes, &Themes::changed, this, qOverload<>(&QWidget::update));
}

}  // namespace keyblock
