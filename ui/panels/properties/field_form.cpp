// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/properties/field_form.h"

#include "solver/scene/pointer.h"
#include "ui/document/document.h"
#include "ui/edit/edits.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/panels/fields/field_target.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/properties/field_help.h"
#include "ui/panels/properties/form_row_widget.h"

#include <QApplication>
#include <QTimer>
#include <QVBoxLayout>

#include <limits>
#include <set>
#include <utility>

namespace keyblock {

namespace {

/// The structure of a form. Two structures are equal if no widget must be added or removed.
QStringList shapeOf(const std::vector<FormGroup>& groups) {
    QStringList shape;
    for (const FormGroup& group : groups) {
        shape << QString("# %1 %2").arg(QString::fromStdString(group.id)).arg(group.depth);
        for (const FormRow& row : group.rows)
            shape << QString("%1 %2").arg(QString::fromStdString(row.path)).arg(static_cast<int>(row.field->kind));
    }
    return shape;
}

QString lowered(QString text) {
    const bool isName = text.size() > 1 && text[1].isUpper();
    if (!text.isEmpty() && !isName && !text.startsWith("Young") && !text.startsWith("Poisson"))
        text[0] = text[0].toLower();
    return text;
}

/// The object or objects of a row, such as `J1`, `load 2 of stage burst` or `3 joint sets`.
QString subjectOf(const Scene& scene, const FormRow& row) {
    if (row.pointers.size() > 1) return countedOf(*row.structure, static_cast<int>(row.pointers.size()));
    const std::string object = row.renames ? row.pointers.front() : parentOf(row.pointers.front());
    const std::string name = nameAt(scene, object);
    return QString::fromStdString(name.empty() ? titleAt(scene, object) : name);
}

Edit setAt(Scene scene, const std::string& pointer, const FieldValue& value) {
    return std::holds_alternative<std::monostate>(value) ? setNullAt(std::move(scene), pointer)
                                                         : setValueAt(std::move(scene), pointer, value);
}

}  // namespace

FieldForm::FieldForm(const FormContext& context, QWidget* parent)
    : QWidget(parent), context_(context), later_(new QTimer(this)) {
    setObjectName("fieldForm");
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    later_->setSingleShot(true);
    later_->setInterval(0);
    connect(later_, &QTimer::timeout, this, &FieldForm::refresh);
    connect(&context.document, &Document::changed, this, &FieldForm::schedule);
    connect(&context.document, &Document::checkedChanged, this, &FieldForm::schedule);
    connect(&context.display, &Display::changed, this, &FieldForm::schedule);
    connect(&context.themes, &Themes::changed, this, &FieldForm::schedule);
}

void FieldForm::schedule() { later_->start(); }

void FieldForm::setObjects(std::vector<std::string> pointers) {
    if (pointers == pointers_) return;
    if (QWidget* focus = QApplication::focusWidget(); focus && isAncestorOf(focus)) focus->clearFocus();  // enters it
    pointers_ = std::move(pointers);
    for (FormRowWidget* row : rows_) row->setRefusal({});
    refresh();
}

void FieldForm::setFilter(const QString& text) {
    if (text == filter_) return;
    filter_ = text;
    refresh();
}

void FieldForm::refresh() {
    later_->stop();
    const auto before = std::exchange(shown_, context_.document.scene());  // rows refer to it until they are updated
    const auto groups = matching(formGroups(*shown_, pointers_), filter_);
    const QStringList shape = shapeOf(groups);
    if (!content_ || shape != shape_) {
        shape_ = shape;
        rebuild(groups);
    }
    update(groups);
}

QString FieldForm::focusedPath() const {
    for (const FormRowWidget* row : rows_)
        if (row->isAncestorOf(QApplication::focusWidget())) return QString::fromStdString(row->row().path);
    return {};
}

void FieldForm::rebuild(const std::vector<FormGroup>& groups) {
    const QString focus = focusedPath();
    rows_.clear();
    headings_.clear();
    bodies_.clear();
    if (content_) {
        content_->hide();
        content_->deleteLater();
    }
    content_ = new QWidget(this);
    auto* column = new QVBoxLayout(content_);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(0);
    layout()->addWidget(content_);
    for (const FormGroup& group : groups) addGroup(group);
    column->addStretch(1);
    showOpen();
    content_->show();
    if (!focus.isEmpty()) focusField(focus);
}

void FieldForm::addGroup(const FormGroup& group) {
    const QString id = QString::fromStdString(group.id);
    auto* heading = new FormHeading(group, isOpen(group), context_, content_);
    auto* body = new QWidget(content_);
    auto* rows = new QVBoxLayout(body);
    rows->setContentsMargins(0, group.rows.empty() ? 0 : 4, 0, group.rows.empty() ? 0 : 6);
    rows->setSpacing(0);
    for (const FormRow& row : group.rows) {
        auto* widget = new FormRowWidget(row, context_, body);
        connect(widget, &FormRowWidget::entered, this,
                [this, widget](const FieldValue& value) { enter(*widget, value); });
        connect(widget, &FormRowWidget::resetAsked, this, [this, widget] { reset(widget->row()); });
        connect(widget, &FormRowWidget::targetAsked, this,
                [this, widget] { Q_EMIT targetAsked(QString::fromStdString(targetOf(widget->row()))); });
        connect(widget, &FormRowWidget::varyAsked, this, [this, widget] {
            QStringList fields;
            for (const std::string& pointer : widget->row().pointers) fields << QString::fromStdString(pointer);
            Q_EMIT varyAsked(fields);
        });
        connect(widget, &FormRowWidget::focused, this, [this, widget] { Q_EMIT rowFocused(widget->row()); });
        rows->addWidget(widget);
        rows_.push_back(widget);
    }
    connect(heading, &FormHeading::toggled, this, [this, id] {
        if (!toggled_.remove(id)) toggled_.insert(id);
        showOpen();
    });
    connect(heading, &FormHeading::addAsked, this, [this](const QString& pointer) {
        const Scene& scene = *context_.document.scene();
        Edit edit = appendAt(scene, pointer.toStdString());
        const QString made = edit.made.empty() ? tr("part") : QString::fromStdString(titleAt(edit.scene, edit.made));
        context_.document.apply(tr("Add %1").arg(made), std::move(edit));
    });
    connect(heading, &FormHeading::removeAsked, this, [this](const QString& pointer) {
        const Scene& scene = *context_.document.scene();
        const QString title = QString::fromStdString(titleAt(scene, pointer.toStdString()));
        context_.document.apply(tr("Remove %1").arg(title), removeAt(scene, pointer.toStdString()));
    });
    content_->layout()->addWidget(heading);
    content_->layout()->addWidget(body);
    headings_.push_back(heading);
    bodies_.push_back(body);
}

bool FieldForm::isOpen(const FormGroup& group) const {
    if (!filter_.isEmpty()) return true;
    return group.closedAtFirst == toggled_.contains(QString::fromStdString(group.id));
}

/// A closed group also hides the groups inside it.
void FieldForm::showOpen() {
    int closedAt = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < headings_.size(); ++i) {
        const FormGroup& group = headings_[i]->group();
        if (group.depth <= closedAt) closedAt = std::numeric_limits<int>::max();
        const bool inside = group.depth > closedAt;
        const bool open = isOpen(group) && !inside;
        headings_[i]->setVisible(!inside);
        bodies_[i]->setVisible(open && !group.rows.empty());
        if (!open && !inside) closedAt = group.depth;
    }
}

void FieldForm::update(const std::vector<FormGroup>& groups) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        headings_[i]->present(groups[i]);
        for (const FormRow& row : groups[i].rows) {
            bool error = false;
            const QString problems = problemsAt(row, error);
            rows_[next++]->present(row, problems, error);
        }
    }
}

QString FieldForm::problemsAt(const FormRow& row, bool& error) const {
    QStringList lines;
    const std::set<std::string> pointers(row.pointers.begin(), row.pointers.end());
    for (const Problem& problem : context_.document.checked().problems) {
        if (problem.severity == Severity::Note || row.renames || !liesIn(pointers, problem.pointer)) continue;
        error = error || problem.severity == Severity::Error;
        lines << QString::fromStdString(problem.message);
        if (!problem.remedy.empty()) lines.back() += ". " + QString::fromStdString(problem.remedy);
    }
    lines.removeDuplicates();
    return lines.join('\n');
}

void FieldForm::enter(FormRowWidget& widget, const FieldValue& value) {
    const FormRow row = widget.row();
    if (const QString why = outOfRange(row, value, context_); !why.isEmpty()) return widget.setRefusal(why);
    const QString step =
        tr("Set %1 of %2").arg(lowered(labelOf(*row.field)), subjectOf(*context_.document.scene(), row));
    applyToAll(&widget, row, step, [&](Scene scene, const std::string& pointer) {
        if (row.renames) return renameAt(scene, pointer, std::get<std::string>(value));
        return setAt(std::move(scene), pointer, value);
    });
}

void FieldForm::reset(const FormRow& row) {
    const QString step =
        tr("Reset %1 of %2").arg(lowered(labelOf(*row.field)), subjectOf(*context_.document.scene(), row));
    applyToAll(nullptr, row, step,
               [](Scene scene, const std::string& pointer) { return resetAt(std::move(scene), pointer); });
}

void FieldForm::applyToAll(FormRowWidget* widget, const FormRow& row, const QString& step,
                           const std::function<Edit(Scene, const std::string&)>& edit) {
    Edit all{*context_.document.scene()};
    for (const std::string& pointer : row.pointers) {
        all = edit(std::move(all.scene), pointer);
        if (all.done()) continue;
        if (widget) widget->setRefusal(QString::fromStdString(all.refusal));
        return;
    }
    if (widget) widget->setRefusal({});
    context_.document.apply(step, std::move(all));
    schedule();
}

bool FieldForm::focusField(const QString& path) {
    for (FormRowWidget* row : rows_)
        if (isWithin('/' + path.toStdString(), '/' + row->row().path)) {
            row->editor().setFocus();
            return true;
        }
    return false;
}

}  // namespace keyblock
