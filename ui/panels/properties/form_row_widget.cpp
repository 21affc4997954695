// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/properties/form_row_widget.h"

#include "ui/look/display.h"
#include "ui/look/elided_label.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/panels/fields/field_target.h"
#include "ui/panels/fields/field_words.h"

#include <QContextMenuEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QStyle>
#include <QToolButton>

namespace keyblock {

namespace {

constexpr int formInset = 12, formRowHeight = 25, headingHeight = 26, indent = 10;
constexpr int valueWidth = 100, stressWidth = 76, flagWidth = 16, unitWidth = 38, metreWidth = 18, arrowSize = 16, gap = 6;

QToolButton* smallButton(QWidget* parent, const QString& tip, const char* name) {
    auto* button = new QToolButton(parent);
    button->setProperty("small", true);
    button->setFixedSize(arrowSize, arrowSize);
    button->setIconSize({12, 12});
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void setWeight(QLabel& label, bool bold) {
    QFont font = label.font();
    font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
    label.setFont(font);
}

}  // namespace

FormRowWidget::FormRowWidget(const FormRow& row, const FormContext& context, QWidget* parent)
    : QWidget(parent), context_(context), row_(row), editor_(makeValueEditor(row, context, this)),
      label_(new ElidedLabel(this)), unit_(new QLabel(this)),
      reset_(smallButton(this, tr("Reset to default"), "reset")), target_(smallButton(this, {}, "target")),
      problem_(new QLabel(this)) {
    setObjectName(QString::fromStdString("row:" + row.path));
    if (row.structure && row.field)
        setProperty("helpTopic", QString::fromStdString("scene#" + std::string(row.structure->name) + "/" +
                                                        std::string(row.field->key)));
    unit_->setProperty("role", "unit");
    problem_->setWordWrap(true);
    problem_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label_->setBuddy(editor_);
    layOut();
    for (QLineEdit* line : editor_->findChildren<QLineEdit*>()) line->installEventFilter(this);
    connect(editor_, &ValueEditor::entered, this, &FormRowWidget::entered);
    connect(editor_, &ValueEditor::refused, this, &FormRowWidget::setRefusal);
    connect(editor_, &ValueEditor::takenBack, this, [this] { setRefusal({}); });
    connect(editor_, &ValueEditor::focused, this, &FormRowWidget::focused);
    connect(reset_, &QToolButton::clicked, this, &FormRowWidget::resetAsked);
    connect(target_, &QToolButton::clicked, this, &FormRowWidget::targetAsked);
}

void FormRowWidget::layOut() {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(formInset, 2, 4, 2);
    grid->setHorizontalSpacing(0);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    const bool wide = editor_->isWide();
    const bool acrossUnit = editor_->tellsUnit();
    const bool isPlace = row_.field->kind == FieldKind::Vector && row_.field->unit == "m";  // two numbers need space
    const int forUnit = isPlace ? metreWidth : unitWidth;
    grid->addWidget(label_, 0, 0);
    if (wide) {
        grid->addWidget(editor_, 1, 0, 1, 4);
    } else {
        const int span = acrossUnit ? 2 : 1;
        const bool flag = row_.field->kind == FieldKind::Flag;  // a check box leaves space for its label
        const int further = acrossUnit ? gap + unitWidth : unitWidth - forUnit;
        const bool leads = namesObject(row_);
        const int forTarget = leads ? gap + arrowSize : 0;
        const bool isStress = row_.field->isStress && row_.field->kind == FieldKind::Number;  // sign in its label
        editor_->setFixedWidth(flag ? flagWidth : (isStress ? stressWidth : valueWidth) + further - forTarget);
        auto* value = new QHBoxLayout;
        value->setSpacing(gap);
        value->addWidget(editor_);
        if (leads) value->addWidget(target_);
        grid->addLayout(value, 0, 1, 1, span);
    }
    if (!acrossUnit) grid->addWidget(unit_, 0, 2);
    unit_->setVisible(!acrossUnit);
    unit_->setFixedWidth(gap + forUnit);
    unit_->setContentsMargins(gap, 0, 0, 0);
    label_->setContentsMargins(0, 0, 4, 0);
    grid->addWidget(reset_, 0, 3);
    grid->addWidget(problem_, 2, 0, 1, 4);
    grid->setRowMinimumHeight(0, formRowHeight - 4);
    problem_->hide();
}

/// Whether a study can vary the field: a number, a choice or a text, but not the name of the object.
bool FormRowWidget::canVary() const {
    if (!row_.field || row_.renames || isName(*row_.field)) return false;
    switch (row_.field->kind) {
        case FieldKind::Flag:
        case FieldKind::Number:
        case FieldKind::Integer:
        case FieldKind::Text:
        case FieldKind::Word: return true;
        default: return false;
    }
}

/// Lines have a menu of their own, to which the entry is added.
bool FormRowWidget::eventFilter(QObject* watched, QEvent* event) {
    auto* line = qobject_cast<QLineEdit*>(watched);
    if (!line || event->type() != QEvent::ContextMenu || !canVary()) return QWidget::eventFilter(watched, event);
    showMenu(line, static_cast<QContextMenuEvent*>(event)->globalPos());
    return true;
}

void FormRowWidget::contextMenuEvent(QContextMenuEvent* event) {
    if (canVary()) showMenu(nullptr, event->globalPos());
}

void FormRowWidget::showMenu(QLineEdit* line, const QPoint& place) {
    QMenu* menu = line ? line->createStandardContextMenu() : new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (line) menu->addSeparator();
    menu->addAction(tr("Vary in a study…"), this, &FormRowWidget::varyAsked)->setObjectName("varyInStudy");
    menu->popup(place);
}

void FormRowWidget::present(const FormRow& row, const QString& problems, bool error) {
    row_ = row;
    label_->setText(labelOf(*row.field, context_.display));
    setWeight(*label_, row.changed);
    const std::string_view unit = unitOf(row.at, *row.field);
    unit_->setText(unit.empty() ? QString() : context_.display.shown(unit).symbol);
    unit_->setToolTip(unit_->text());
    reset_->setIcon(context_.themes.icon("reset", context_.themes.current().accent));
    QSizePolicy keepsPlace = reset_->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    reset_->setSizePolicy(keepsPlace);
    reset_->setVisible(row.changed && row.resettable);
    showTarget();
    problems_ = problems;
    error_ = error;
    editor_->present(row);
    showProblem();
}

void FormRowWidget::showTarget() {
    const bool leads = !targetOf(row_).empty() && !row_.mixed;
    target_->setVisible(namesObject(row_));
    target_->setEnabled(leads);
    target_->setIcon(context_.themes.icon("chevron-right"));
    const QString tip = tr("Show the properties of %1").arg(QString::fromStdString(nameOfTarget(row_)));
    target_->setToolTip(leads ? asTip(tip) : QString());
    target_->setAccessibleName(leads ? tip : tr("Show the properties of the object"));
}

void FormRowWidget::setRefusal(const QString& why) {
    refusal_ = why;
    editor_->setRefused(!why.isEmpty());
    showProblem();
}

void FormRowWidget::showProblem() {
    const QString text = refusal_.isEmpty() ? problems_ : refusal_;
    problem_->setText(text);
    problem_->setVisible(!text.isEmpty());
    problem_->setProperty("role", refusal_.isEmpty() && !error_ ? "warning" : "problem");
    problem_->style()->unpolish(problem_);
    problem_->style()->polish(problem_);
}

FormHeading::FormHeading(const FormGroup& group, bool open, const FormContext& context, QWidget* parent)
    : QWidget(parent), context_(context), open_(open), fold_(smallButton(this, tr("Expand or collapse"), "fold")),
      title_(new ElidedLabel(this)), detail_(new QLabel(this)), add_(smallButton(this, tr("Add"), "add")),
      remove_(smallButton(this, tr("Remove"), "remove")) {
    setObjectName("formHeading");
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(headingHeight);
    setWeight(*title_, true);
    detail_->setProperty("role", "unit");
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(formInset + group.depth * indent - 4, 0, 4, 0);
    layout->setSpacing(4);
    layout->addWidget(fold_);
    layout->addWidget(title_, 1);
    layout->addWidget(detail_);
    layout->addWidget(add_);
    layout->addWidget(remove_);
    connect(fold_, &QToolButton::clicked, this, [this] {
        open_ = !open_;
        paintFold();
        Q_EMIT toggled(open_);
    });
    connect(add_, &QToolButton::clicked, this, [this] { Q_EMIT addAsked(QString::fromStdString(group_.addTo)); });
    connect(remove_, &QToolButton::clicked, this,
            [this] { Q_EMIT removeAsked(QString::fromStdString(group_.remove)); });
    present(group);
}

void FormHeading::present(const FormGroup& group) {
    group_ = group;
    title_->setText(group.title);
    detail_->setText(group.detail);
    add_->setVisible(!group.addTo.empty());
    add_->setAccessibleName(tr("Add to %1").arg(group.title));
    remove_->setVisible(!group.remove.empty());
    remove_->setAccessibleName(tr("Remove %1").arg(group.title));
    fold_->setAccessibleName(tr("Expand or collapse %1").arg(group.title));
    add_->setIcon(context_.themes.icon("plus"));
    remove_->setIcon(context_.themes.icon("delete"));
    paintFold();
}

void FormHeading::paintFold() { fold_->setIcon(context_.themes.icon(open_ ? "chevron-down" : "chevron-right")); }

void FormHeading::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) fold_->click();
}

}  // namespace keyblock
