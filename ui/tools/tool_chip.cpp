// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_chip.h"

#include "ui/edit/typed_number.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/tools/tool_painter.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>

#include <algorithm>

namespace keyblock {
namespace {

constexpr int chipHeight = 26, leastEdit = 22, mostOfChoice = 180;  // [px]

}  // namespace

ToolChip::ToolChip(ToolField field, const Display& display, const Themes& themes, QWidget* parent)
    : QFrame(parent), field_(std::move(field)), display_(display), themes_(themes) {
    setObjectName("toolChip");
    setFixedHeight(chipHeight);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(5);
    auto* label = new QLabel(field_.label, this);
    label->setObjectName("chipLabel");
    row->addWidget(label);
    field_.choices.isEmpty() ? makeEdit() : makeChoice();
    setToolTip(field_.help);
    connect(&themes, &Themes::changed, this, &ToolChip::showTheme);
    connect(&display, &Display::changed, this, &ToolChip::showValue);
    showTheme();
    showValue();
}

void ToolChip::makeChoice() {
    choice_ = new QComboBox(this);
    choice_->setObjectName("option." + field_.id);
    choice_->setAccessibleName(field_.label);
    choice_->addItems(field_.shownChoices());
    choice_->setFocusPolicy(Qt::ClickFocus);
    choice_->installEventFilter(this);
    layout()->addWidget(choice_);
    connect(choice_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        const bool none = !field_.none.isEmpty() && index == 0;  // by index: a choice may have the same text
        field_.set(none ? FieldValue{} : FieldValue(field_.choices.value(index).toStdString()));
        Q_EMIT done();
    });
}

void ToolChip::makeEdit() {
    edit_ = new QLineEdit(this);
    edit_->setObjectName("option." + field_.id);
    edit_->setAccessibleName(field_.label);
    edit_->setFrame(false);
    edit_->setAlignment(Qt::AlignRight);
    edit_->setFocusPolicy(Qt::ClickFocus);
    edit_->setPlaceholderText(field_.none);
    edit_->installEventFilter(this);
    layout()->addWidget(edit_);
    if (!field_.unit.isEmpty()) {
        auto* unit = new QLabel(shownUnit(), this);
        unit->setObjectName("chipUnit");
        layout()->addWidget(unit);
        connect(&display_, &Display::changed, unit, [this, unit] { unit->setText(shownUnit()); });
    }
    connect(edit_, &QLineEdit::textEdited, this, [this] { take(false); });
    connect(edit_, &QLineEdit::editingFinished, this, [this] { take(true); });
}

QString ToolChip::shownUnit() const { return display_.shown(field_.unit.toStdString()).symbol; }

void ToolChip::showTheme() {
    const Theme& t = themes_.current();
    setStyleSheet(QString("#toolChip { background: %1; border: 1px solid %2; border-radius: 4px; }"
                          "#toolChip[active=\"true\"] { border: 2px solid %3; }"
                          "#toolChip[wrong=\"true\"] { border: 2px solid %4; background: %5; }"
                          "#chipLabel, #chipUnit { color: %6; border: none; background: transparent; }"
                          "QLineEdit { border: none; background: transparent; padding: 0; color: %7; }"
                          "QComboBox { border: none; background: transparent; padding: 0; min-height: 18px; color: %7; }"
                          "QComboBox:focus { border: none; padding: 0; }")
                      .arg(t.panel.name(), t.border.name(), t.accent.name(), t.error.name(), t.errorSoft.name(),
                           t.text2.name(), t.text.name()));
}

void ToolChip::refresh(ToolField field) {
    field_ = std::move(field);
    if (choice_ && [&] {
            QStringList items;
            for (int i = 0; i < choice_->count(); ++i) items << choice_->itemText(i);
            return items != field_.shownChoices();
        }()) {
        choice_->clear();
        choice_->addItems(field_.shownChoices());
    }
    if (!edit_ || !edit_->hasFocus()) showValue();
}

void ToolChip::showValue() {
    const FieldValue value = field_.get();
    if (choice_) {
        const auto* text = std::get_if<std::string>(&value);
        choice_->setCurrentIndex(text ? field_.choices.lastIndexOf(QString::fromStdString(*text)) : 0);
        // The box is as wide as the current choice, and its list as wide as the longest one.
        choice_->setFixedWidth(std::min(choice_->fontMetrics().horizontalAdvance(choice_->currentText()) + 30, mostOfChoice));
        QFontMetrics metrics = choice_->fontMetrics();
        int widest = choice_->width();
        for (const QString& item : field_.shownChoices())
            widest = std::max(widest, metrics.horizontalAdvance(item) + 32);
        choice_->view()->setMinimumWidth(std::min(widest, 3 * mostOfChoice));
        return;
    }
    QString text;
    if (const auto* number = std::get_if<double>(&value)) {
        const double shown = *number * display_.shown(field_.unit.toStdString()).factor;
        text = field_.isInteger ? QString::number(shown, 'f', 0)
               : field_.unit == QString::fromUtf8("°") ? angleText(shown).chopped(1)
                                                       : fieldText(shown);
    } else if (const auto* words = std::get_if<std::string>(&value)) {
        text = QString::fromStdString(*words);
    }
    edit_->setText(text);
    const QString widest = std::max(text, field_.none, [](const QString& a, const QString& b) { return a.size() < b.size(); });
    edit_->setFixedWidth(std::max(leastEdit, edit_->fontMetrics().horizontalAdvance(widest) + 6));
    setWrong({});
}

void ToolChip::take(bool finally) {
    const QString text = edit_->text().trimmed();
    QString problem;
    const FieldValue before = field_.get();
    if (text.isEmpty() && !field_.none.isEmpty()) {
        problem = field_.set(FieldValue{});
    } else if (std::holds_alternative<std::string>(before) && field_.unit.isEmpty() && !field_.isInteger) {
        problem = field_.set(text.toStdString());
    } else {
        const ShownUnit unit = display_.shown(field_.unit.toStdString());
        const TypedNumber typed = typedNumber(text.toStdString(), unit.symbol.toStdString());
        problem = typed.value ? field_.set(*typed.value / unit.factor) : QString::fromStdString(typed.problem);
    }
    if (finally && problem.isEmpty())
        showValue();
    else
        setWrong(problem);
}

void ToolChip::setWrong(const QString& problem) {
    setToolTip(problem.isEmpty() ? field_.help : problem);
    if (property("wrong").toBool() == !problem.isEmpty()) return;
    setProperty("wrong", !problem.isEmpty());
    style()->unpolish(this);
    style()->polish(this);
}

void ToolChip::enter() {
    if (choice_) return choice_->setFocus(Qt::TabFocusReason);
    edit_->setFocus(Qt::TabFocusReason);
    edit_->selectAll();
}

/// Tab moves from field to field. Qt's own order would leave the bar, because the fields do not accept focus by Tab.
bool ToolChip::isPassing(QEvent& event) {
    if (event.type() != QEvent::KeyPress && event.type() != QEvent::ShortcutOverride) return false;
    const int key = static_cast<QKeyEvent&>(event).key();
    if (key != Qt::Key_Tab && key != Qt::Key_Backtab) return false;
    event.accept();
    if (event.type() == QEvent::ShortcutOverride) return true;
    if (edit_) take(true);
    if (property("wrong").toBool()) enter();  // stays here, so that the next input replaces the wrong one
    else Q_EMIT passed(key == Qt::Key_Tab);
    return true;
}

bool ToolChip::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        setProperty("active", event->type() == QEvent::FocusIn);
        style()->unpolish(this);
        style()->polish(this);
    }
    if (isPassing(*event)) return true;
    const bool isKey = edit_ && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride);
    const int key = isKey ? static_cast<QKeyEvent*>(event)->key() : 0;
    if (key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Escape) return QFrame::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::ShortcutOverride) return true;
    if (key == Qt::Key_Escape)
        showValue();
    else
        take(true);
    if (!property("wrong").toBool()) Q_EMIT done();
    return true;
}

}  // namespace keyblock
