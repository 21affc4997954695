// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/coordinate_box.h"

#include "ui/edit/typed_point.h"
#include "ui/look/theme.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>

namespace keyblock {
namespace {

constexpr int fieldWidth = 106, fieldHeight = 25;

QString shown(double number) { return QString::number(number, 'f', 3).replace('-', QChar(0x2212)); }

/// Whether the text gives both coordinates. A comma does not count: x and y have separate fields, so it is a decimal
/// comma.
bool saysWholePlace(const QString& text) { return text.contains('@') || text.contains('<') || text.contains(';'); }

}  // namespace

CoordinateBox::CoordinateBox(QWidget& canvas, const Themes& themes) : QFrame(&canvas), themes_(themes), canvas_(canvas) {
    setObjectName("coordinateBox");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(5, 5, 5, 4);
    grid->setSpacing(6);
    const std::array names{tr("x"), tr("y")};
    for (int i = 0; i < 2; ++i) {
        auto* frame = new QFrame(this);
        frame->setObjectName("coordinateField");
        frame->setFixedSize(fieldWidth, fieldHeight);
        auto* row = new QHBoxLayout(frame);
        row->setContentsMargins(8, 0, 6, 0);
        row->setSpacing(3);
        row->addWidget(new QLabel(names[i], frame));
        auto* edit = new QLineEdit(frame);
        edit->setObjectName(QString("coordinate.") + (i == 0 ? "x" : "y"));
        edit->setAccessibleName(i == 0 ? tr("x of the next point") : tr("y of the next point"));
        edit->setAlignment(Qt::AlignRight);
        edit->setFrame(false);
        edit->setFocusPolicy(Qt::ClickFocus);
        edit->installEventFilter(this);
        row->addWidget(edit, 1);
        row->addWidget(new QLabel(tr("m"), frame));
        grid->addWidget(frame, 0, i);
        edits_[i] = edit;
        connect(edit, &QLineEdit::textEdited, this, [this] { say({}, false); });
    }
    hint_ = new QLabel(this);
    hint_->setObjectName("coordinateHint");
    hint_->setFixedWidth(2 * fieldWidth + 6);
    hint_->setWordWrap(true);
    grid->addWidget(hint_, 1, 0, 1, 2);
    connect(&themes, &Themes::changed, this, &CoordinateBox::showTheme);
    showTheme();
    say({}, false);
    hide();
}

void CoordinateBox::showTheme() {
    const Theme& t = themes_.current();
    setStyleSheet(QString("#coordinateBox { background: %1; border: 1px solid %2; border-radius: 4px; }"
                          "#coordinateField { background: %3; border: 1px solid %2; border-radius: 3px; }"
                          "#coordinateField[active=\"true\"] { border: 2px solid %4; }"
                          "#coordinateField QLabel { color: %5; border: none; }"
                          "#coordinateField QLineEdit { border: none; background: transparent; padding: 0; font-weight: 600;"
                          " color: %6; }"
                          "#coordinateHint { color: %5; font-size: 11px; border: none; }"
                          "#coordinateHint[wrong=\"true\"] { color: %7; }")
                      .arg(t.panel.name(), t.border.name(), t.field.name(), t.accent.name(), t.text2.name(), t.text.name(),
                           t.error.name()));
}

void CoordinateBox::follow(const Point& place, const QPointF& pixel, const std::optional<Point>& previous,
                           bool belowTag) {
    mouse_ = place;
    previous_ = previous;
    if (!typing_) showPlace();
    moveBeside(pixel, belowTag);
    if (!isVisible()) {
        show();
        raise();
    }
}

void CoordinateBox::showPlace() {
    edits_[0]->setText(shown(mouse_.x()));
    edits_[1]->setText(shown(mouse_.y()));
}

void CoordinateBox::moveBeside(const QPointF& pixel, bool belowTag) {
    adjustSize();
    QPoint at = (pixel + (belowTag ? QPointF(34, 48) : QPointF(24, 24))).toPoint();
    const QWidget& room = *parentWidget();
    if (at.x() + width() > room.width() - 4) at.setX(qRound(pixel.x()) - 24 - width());
    if (at.y() + height() > room.height() - 4) at.setY(qRound(pixel.y()) - 24 - height());
    move(std::max(at.x(), 0), std::max(at.y(), 0));
}

void CoordinateBox::begin(const QString& text, const std::optional<Point>& previous) {
    previous_ = previous;
    typing_ = true;
    both_ = false;
    if (!isVisible()) moveBeside(QPointF(0.5 * parentWidget()->width(), 0.5 * parentWidget()->height()), false);
    show();
    raise();
    edits_[0]->setFocus();
    if (text.isEmpty())
        edits_[0]->selectAll();
    else
        edits_[0]->setText(text);
    edits_[1]->setText(shown(mouse_.y()));
    say({}, false);
}

void CoordinateBox::stop() {
    const bool had = typing_;
    typing_ = both_ = false;
    hide();
    say({}, false);
    if (had) canvas_.setFocus();
}

void CoordinateBox::say(const QString& text, bool wrong) {
    hint_->setText(wrong ? text : tr("Tab: next field · @2,0: relative · @3<45: polar"));
    hint_->setProperty("wrong", wrong);
    hint_->style()->unpolish(hint_);
    hint_->style()->polish(hint_);
    adjustSize();
}

void CoordinateBox::nextField() {
    both_ = true;
    QLineEdit* next = edits_[edits_[0]->hasFocus() ? 1 : 0];
    next->setFocus();
    next->selectAll();
}

void CoordinateBox::take() {
    const QString x = edits_[0]->text();
    const QString text = !both_ || saysWholePlace(x) ? x : x + ';' + edits_[1]->text();
    const TypedPoint typed = typedPoint(text.toStdString(), {previous_, mouse_});
    if (!typed.place) return say(QString::fromStdString(typed.problem), true);
    stop();
    Q_EMIT placed(*typed.place);
}

bool CoordinateBox::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        QWidget* frame = static_cast<QWidget*>(watched)->parentWidget();
        frame->setProperty("active", event->type() == QEvent::FocusIn);
        frame->style()->unpolish(frame);
        frame->style()->polish(frame);
        const auto reason = static_cast<QFocusEvent*>(event)->reason();
        if (event->type() == QEvent::FocusOut && reason == Qt::MouseFocusReason && typing_) {
            typing_ = both_ = false;  // a click elsewhere ends the input
            showPlace();
        }
    }
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return QFrame::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool ours = key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab ||
                      key == Qt::Key_Backtab;
    if (!ours) return QFrame::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::ShortcutOverride) return true;
    if (key == Qt::Key_Escape)
        stop();
    else if (key == Qt::Key_Tab || key == Qt::Key_Backtab)
        nextField();
    else
        take();
    return true;
}

}  // namespace keyblock
