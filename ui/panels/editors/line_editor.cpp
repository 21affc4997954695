// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editors/line_editor.h"

#include "ui/document/document.h"
#include "ui/look/field_text.h"
#include "ui/look/plain_text.h"
#include "ui/panels/calm_box.h"
#include "ui/panels/fields/field_choices.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/value_text.h"
#include "ui/panels/filter_line.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyle>
#include <QVariant>

namespace keyblock {

namespace {

constexpr int fieldHeight = 21;

void fill(ValueEditor& editor, QWidget& widget) {
    auto* layout = new QHBoxLayout(&editor);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&widget);
    editor.setFocusProxy(&widget);
    widget.installEventFilter(&editor);
}

void setBold(QWidget& widget, bool bold) {
    QFont font = widget.font();
    font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
    widget.setFont(font);
}

bool isText(const FormRow& row) { return row.field->kind == FieldKind::Text; }

}  // namespace

LineEditor::LineEditor(const FormRow& row, const FormContext& context, QWidget* parent)
    : ValueEditor(parent), context_(context), line_(new QLineEdit(this)), wide_(row.field->isSentence),
      isText_(isText(row)) {
    line_->setFixedHeight(fieldHeight);
    fill(*this, *line_);
    dimHint(*line_);
    connect(line_, &QLineEdit::editingFinished, this, &LineEditor::enter);
}

void LineEditor::present(const FormRow& row) {
    row_ = row;
    line_->setAlignment((isText(row) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    const bool typing = line_->hasFocus() && line_->text() != shown_;
    if (!refused_ && !typing) showText(line_->hasFocus());
    setBold(*line_, row.changed && !row.mixed);
}

void LineEditor::showText(bool exact) {
    const bool empty = row_.mixed || std::holds_alternative<std::monostate>(row_.value);
    const std::string_view unit = unitOf(row_.at, *row_.field);
    shown_ = empty ? QString() : valueText(row_.value, *row_.field, unit, context_.display, exact);
    const QString null = isText_ ? tr("none") : nullTextOf(row_, context_);
    line_->setPlaceholderText(row_.mixed ? tr("mixed") : row_.field->nullable ? null : QString());
    QFont font = line_->font();
    font.setItalic(row_.mixed);
    line_->setFont(font);
    line_->setText(shown_);
    if (!line_->hasFocus()) line_->setCursorPosition(0);
    line_->setToolTip(isText(row_) ? asTip(shown_) : QString());
}

void LineEditor::enter() {
    if (line_->text() == shown_) {
        if (refused_) Q_EMIT takenBack();
        return;
    }
    const QString text = line_->text();
    if (row_.mixed && text.trimmed().isEmpty()) return showText(false);
    const auto typed = readValue(text, *row_.field, unitOf(row_.at, *row_.field), context_.display);
    if (!typed.value) return Q_EMIT refused(typed.problem);
    shown_ = text;  // entered only once, either by Enter or by losing the focus
    Q_EMIT entered(*typed.value);
}

void LineEditor::setRefused(bool refused) {
    if (refused) shown_.clear();  // so that the next Enter reads it again
    refused_ = refused;
    line_->setProperty("invalid", refused);
    line_->style()->unpolish(line_);
    line_->style()->polish(line_);
    if (!refused) showText(line_->hasFocus());
}

bool LineEditor::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        Q_EMIT focused();
        if (!refused_) showText(true);
    }
    if (event->type() == QEvent::FocusOut && !refused_ && line_->text() == shown_) showText(false);
    const bool escape = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (escape && (refused_ || line_->text() != shown_)) {
        refused_ = false;
        showText(true);
        Q_EMIT takenBack();
        return true;
    }
    return ValueEditor::eventFilter(object, event);
}

ChoiceEditor::ChoiceEditor(const FormContext& context, QWidget* parent)
    : ValueEditor(parent), context_(context), box_(new CalmBox(this)) {
    box_->setFixedHeight(fieldHeight);
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box_->setMinimumContentsLength(4);
    fill(*this, *box_);
    connect(box_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        const QVariant held = box_->itemData(index);
        const bool isNull = !held.isValid();
        const FieldValue value = isNull ? FieldValue() : FieldValue(held.toString().toStdString());
        if (row_.mixed || value != row_.value) Q_EMIT entered(value);
    });
}

void ChoiceEditor::present(const FormRow& row) {
    row_ = row;
    box_->clear();
    if (row.field->nullable) box_->addItem(nullTextOf(row, context_));
    for (const std::string_view word : row.field->words) box_->addItem(choiceText(*row.field, word), fromUtf8(word));
    const auto names = choicesOf(*context_.document.scene(), *row.field);
    for (const std::string& name : names.value_or(std::vector<std::string>{}))
        box_->addItem(QString::fromStdString(name), QString::fromStdString(name));
    const auto* text = std::get_if<std::string>(&row.value);
    const QString now = text ? QString::fromStdString(*text) : QString();
    if (text && !now.isEmpty() && box_->findData(now) < 0) box_->addItem(tr("%1 (missing)").arg(now), now);
    if (row.mixed) {
        box_->setPlaceholderText(tr("mixed"));
        box_->setCurrentIndex(-1);
    } else {
        box_->setCurrentIndex(text && !now.isEmpty() ? box_->findData(now) : row.field->nullable ? 0 : -1);
    }
    setBold(*box_, row.changed && !row.mixed);
    QFont font = box_->font();
    font.setItalic(row.mixed);
    box_->setFont(font);
}

bool ChoiceEditor::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::FocusIn) Q_EMIT focused();
    return ValueEditor::eventFilter(object, event);
}

FlagEditor::FlagEditor(QWidget* parent) : ValueEditor(parent), box_(new QCheckBox(this)) {
    fill(*this, *box_);
    connect(box_, &QCheckBox::clicked, this, [this] {
        box_->setTristate(false);
        Q_EMIT entered(FieldValue(box_->isChecked()));
    });
}

void FlagEditor::present(const FormRow& row) {
    const auto* flag = std::get_if<bool>(&row.value);
    box_->setTristate(row.mixed);
    box_->setCheckState(row.mixed ? Qt::PartiallyChecked : flag && *flag ? Qt::Checked : Qt::Unchecked);
}

bool FlagEditor::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::FocusIn) Q_EMIT focused();
    return ValueEditor::eventFilter(object, event);
}

}  // namespace keyblock
