// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_row.h"

#include "ui/look/qt_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QKeyEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QStyle>
#include <QVariant>

namespace keyblock {

namespace {

constexpr int rowLabelWidth = 150, numberWidth = 110, unitRoom = 64, linesHeight = 66;  // [px]

/// Help of the field table as a tooltip: without marks of code.
QString tipOf(const Field& field) {
    QString help = qt(field.help);
    help.replace("null", StudyRow::tr("empty"));
    return help.remove('`');
}

/// "monte-carlo" as "Monte carlo".
QString wordTitle(std::string_view word) {
    static const QHash<QString, QString> own{{"monte-carlo", StudyRow::tr("Monte Carlo")},
                                             {"latin-hypercube", StudyRow::tr("Latin hypercube")},
                                             {"full-factorial", StudyRow::tr("Full factorial")},
                                             {"none", StudyRow::tr("None")},
                                             {"thin", StudyRow::tr("First and last frame of each stage")},
                                             {"all", StudyRow::tr("All frames")}};
    QString title = qt(word);
    if (own.contains(title)) return own.value(title);
    title.replace('-', ' ');
    title[0] = title[0].toUpper();
    return title;
}

bool isShortField(const Field& field) {
    return field.kind == FieldKind::Number || field.kind == FieldKind::Integer || field.kind == FieldKind::Vector;
}

}  // namespace

StudyRow::StudyRow(const std::string& pointer, const StudyPlace& place, const QString& label, QWidget* parent)
    : QWidget(parent), pointer_(pointer), place_(place), label_(new QLabel(this)), unit_(new QLabel(this)),
      problem_(new QLabel(this)) {
    const Field& field = *place.field;
    setObjectName("studyRow:" + qt(pointer));
    setProperty("helpTopic", "study#" + qt(place.structure->name) + "/" + qt(field.key));
    label_->setText(label.isEmpty() ? qt(labelText(field)) : label);
    label_->setFixedWidth(rowLabelWidth);
    unit_->setText(qt(field.unit));
    unit_->setProperty("role", "unit");
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText);
    problem_->setObjectName("studyProblem");
    QWidget* editor = makeEditor(field);
    editor->setAccessibleName(label_->text());
    editor->setToolTip(tipOf(field));
    label_->setBuddy(editor);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 2, 0, 2);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->addWidget(label_, 0, 0, lines_ ? Qt::AlignTop : Qt::AlignVCenter);
    grid->addWidget(editor, 0, 1);
    if (isShortField(field)) {
        editor->setFixedWidth(numberWidth);
        grid->addWidget(unit_, 0, 2);
        grid->setColumnStretch(3, 1);
    } else {
        unit_->hide();
        grid->setColumnStretch(1, 1);
    }
    grid->addWidget(problem_, 1, 1, 1, 3);
    showEmpty();
    problem_->hide();
}

QWidget* StudyRow::makeEditor(const Field& field) {
    if (field.kind == FieldKind::Word) {
        words_ = new QComboBox(this);
        for (const std::string_view word : field.words) words_->addItem(wordTitle(word), qt(word));
        words_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
        connect(words_, qOverload<int>(&QComboBox::activated), this, &StudyRow::enter);
        return words_;
    }
    if (field.kind == FieldKind::Flag) {
        flag_ = new QCheckBox(this);
        connect(flag_, &QCheckBox::clicked, this, [this](bool on) { Q_EMIT entered(pointer_, FieldValue(on)); });
        return flag_;
    }
    if (field.kind == FieldKind::TextList && field.isSentence) {
        lines_ = new QPlainTextEdit(this);
        lines_->setFixedHeight(linesHeight);
        lines_->setTabChangesFocus(true);
        lines_->installEventFilter(this);
        connect(lines_, &QPlainTextEdit::textChanged, this, &StudyRow::showEmpty);
        return lines_;
    }
    line_ = new QLineEdit(this);
    line_->installEventFilter(this);
    if (field.nullable) line_->setPlaceholderText(tr("none"));
    connect(line_, &QLineEdit::editingFinished, this, &StudyRow::enter);
    connect(line_, &QLineEdit::textChanged, this, &StudyRow::showEmpty);
    return line_;
}

bool StudyRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut && watched == lines_) enter();
    if (event->type() == QEvent::ShortcutOverride) {
        // Ctrl+K finds a command; an editor would delete the rest of its line.
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_K && key->modifiers() == Qt::ControlModifier) {
            event->ignore();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

QString StudyRow::typed() const {
    if (words_) return words_->currentData().toString();
    return lines_ ? lines_->toPlainText() : line_->text();
}

void StudyRow::enter() {
    const QString text = typed();
    if (text == shown_ && refusal_.isEmpty()) return;
    const TypedValue value = typedValue(place_, text);
    refusal_ = value.problem;
    if (value.value) shown_ = text;
    showProblem();
    if (value.value) Q_EMIT entered(pointer_, *value.value);
}

void StudyRow::present(const Study& study) {
    const auto place = placeAt(study, pointer_);
    setVisible(place && place->isUsed());
    if (!place) return;
    place_ = *place;
    if (flag_) return flag_->setChecked(std::get<bool>(place->value()));
    const QString text = typedText(*place);
    if (words_) {
        shown_ = text;
        return words_->setCurrentIndex(words_->findData(text));
    }
    const bool isTyping = (line_ && line_->hasFocus() && line_->isModified()) ||
                          (lines_ && lines_->hasFocus() && lines_->document()->isModified());
    if (!isTyping && refusal_.isEmpty()) showText(text);
}

void StudyRow::showText(const QString& text) {
    shown_ = text;
    if (line_ && line_->text() != text) line_->setText(text);
    if (line_) line_->setCursorPosition(0);
    if (lines_ && lines_->toPlainText() != text) lines_->setPlainText(text);
    if (lines_) lines_->document()->setModified(false);
}

/// The hint of an empty editor has the colour of hints.
void StudyRow::showEmpty() {
    QWidget* editor = line_ ? static_cast<QWidget*>(line_) : lines_;
    if (!editor) return;
    const bool isEmpty = line_ ? line_->text().isEmpty() : lines_->document()->isEmpty();
    if (editor->property("empty").toBool() == isEmpty) return;
    editor->setProperty("empty", isEmpty);
    editor->style()->unpolish(editor);
    editor->style()->polish(editor);
}

void StudyRow::setHint(const QString& hint) {
    if (line_) line_->setPlaceholderText(hint);
    if (lines_) lines_->setPlaceholderText(hint);
    showEmpty();
}

void StudyRow::setUnit(const QString& unit) { unit_->setText(unit); }

void StudyRow::setProblems(const QString& problems, bool isError) {
    problems_ = problems;
    isError_ = isError;
    showProblem();
}

void StudyRow::showProblem() {
    const QString text = refusal_.isEmpty() ? problems_ : refusal_;
    const bool isError = !refusal_.isEmpty() || (isError_ && !problems_.isEmpty());
    problem_->setText(text);
    problem_->setVisible(!text.isEmpty());
    problem_->setProperty("role", isError ? "problem" : "warning");
    problem_->style()->unpolish(problem_);
    problem_->style()->polish(problem_);
    if (!line_) return;
    line_->setProperty("invalid", isError);
    line_->style()->unpolish(line_);
    line_->style()->polish(line_);
}

void StudyRow::takeFocus() {
    for (QWidget* editor : std::initializer_list<QWidget*>{line_, lines_, words_, flag_})
        if (editor) editor->setFocus();
    if (line_) line_->selectAll();
}

}  // namespace keyblock
