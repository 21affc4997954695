// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/properties/property_panel.h"

#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/names.h"
#include "ui/look/display.h"
#include "ui/look/elided_label.h"
#include "ui/look/theme.h"
#include "ui/panels/editors/anchor_strip.h"
#include "ui/panels/editors/stress_strip.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/object_detail.h"
#include "ui/panels/filter_line.h"
#include "ui/panels/properties/field_form.h"
#include "ui/panels/properties/field_help.h"
#include "ui/panels/properties/selection_title.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace keyblock {

namespace {

QLabel* labelOfRole(QWidget* parent, const char* role) {
    auto* label = new ElidedLabel(parent);
    label->setProperty("role", role);
    return label;
}

std::vector<std::string> pointersOf(const QStringList& list) {
    std::vector<std::string> pointers;
    for (const QString& pointer : list) pointers.push_back(pointer.toStdString());
    if (pointers.empty()) pointers.emplace_back();  // the scene
    return pointers;
}

}  // namespace

PropertyPanel::PropertyPanel(const FormContext& context, Selection& selection, QWidget* parent)
    : QWidget(parent), context_(context), selection_(selection), form_(new FieldForm(context)) {
    setObjectName("propertyPanel");
    setAccessibleName(tr("Properties"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeHeader());
    scroll_ = new QScrollArea(this);
    scroll_->setWidgetResizable(true);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* page = new QWidget(scroll_);
    page->setObjectName("propertyPage");
    page->setAttribute(Qt::WA_StyledBackground);
    page_ = new QVBoxLayout(page);
    page_->setContentsMargins(0, 0, 0, 0);
    page_->setSpacing(0);
    strip_ = new AnchorStrip(context, page);
    stress_ = new StressStrip(context, page);
    page_->addWidget(stress_);
    page_->addWidget(form_);
    page_->addWidget(strip_);
    page_->addStretch(1);
    scroll_->setWidget(page);
    column->addWidget(scroll_, 1);
    column->addWidget(makeFoot());
    connect(filter_, &QLineEdit::textChanged, form_, &FieldForm::setFilter);
    connect(form_, &FieldForm::rowFocused, this, &PropertyPanel::showHelp);
    connect(form_, &FieldForm::targetAsked, this, &PropertyPanel::goTo);
    connect(form_, &FieldForm::varyAsked, this, &PropertyPanel::varyAsked);
    connect(&context.document, &Document::moved, this, [this](const WhereNow& now) {
        if (!pin_->isChecked()) return;
        const QStringList left = whereNow(pinned_, now);
        if (left.isEmpty() && !pinned_.isEmpty()) return pin_->setChecked(false);
        if (left != pinned_) present(left);
    });
    connect(&selection, &Selection::changed, this, &PropertyPanel::follow);
    connect(&context.document, &Document::changed, this, &PropertyPanel::showHeader);
    connect(&context.document, &Document::checkedChanged, this, &PropertyPanel::showHeader);
    connect(&context.themes, &Themes::changed, this, &PropertyPanel::showHeader);
    connect(&context.display, &Display::changed, this, &PropertyPanel::showHeader);
    follow();
}

QWidget* PropertyPanel::makeHeader() {
    auto* header = new QWidget(this);
    header->setObjectName("panelHeader");
    header->setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(header);
    column->setContentsMargins(12, 8, 8, 10);
    column->setSpacing(2);
    auto* line = new QHBoxLayout;
    title_ = labelOfRole(header, "title");
    title_->setObjectName("propertyTitle");
    pin_ = new QToolButton(header);
    pin_->setCheckable(true);
    pin_->setFixedSize(22, 22);
    pin_->setToolTip(tr("Keep showing these properties when the selection changes"));
    pin_->setAccessibleName(tr("Pin properties"));
    connect(pin_, &QToolButton::toggled, this, &PropertyPanel::follow);
    line->addWidget(title_, 1);
    line->addWidget(pin_);
    column->addLayout(line);
    detail_ = labelOfRole(header, "detail");
    detail_->setObjectName("propertyDetail");
    column->addWidget(detail_);
    filter_ = new FilterLine(context_.themes, tr("Filter properties"), header);
    filter_->setObjectName("propertyFilter");
    column->addSpacing(6);
    column->addWidget(filter_);
    return header;
}

QWidget* PropertyPanel::makeFoot() {
    auto* foot = new QWidget(this);
    foot->setObjectName("panelFoot");
    foot->setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(foot);
    column->setContentsMargins(12, 8, 12, 10);
    column->setSpacing(2);
    helpTitle_ = new QLabel(foot);
    helpTitle_->setTextFormat(Qt::RichText);
    helpTitle_->setWordWrap(true);
    helpText_ = new QLabel(foot);
    helpText_->setProperty("role", "detail");
    helpText_->setWordWrap(true);
    helpText_->setTextFormat(Qt::PlainText);
    helpText_->setObjectName("fieldHelp");
    helpText_->setAlignment(Qt::AlignTop);
    helpText_->setMinimumHeight(34);
    column->addWidget(helpTitle_);
    column->addWidget(helpText_);
    return foot;
}

void PropertyPanel::follow() {
    if (!pin_->isChecked()) present(selection_.pointers());
}

/// Selects an object named in a field. Built-in types, which cannot be edited, are shown in the library.
void PropertyPanel::goTo(const QString& pointer) {
    const Scene& scene = *context_.document.scene();
    const std::vector<std::string> parts = partsOf(pointer.toStdString());
    const BoltType* type = parts.size() == 2 && parts[0] == "bolt_types" ? findBoltType(scene, parts[1]) : nullptr;
    if (parts.size() == 2 && parts[0] == "bolt_types" && (!type || type->builtIn))
        return Q_EMIT libraryAsked(QString::fromStdString(parts[1]));
    if (!objectAt(scene, pointer.toStdString())) return;
    pin_->setChecked(false);
    selection_.set({pointer});
}

void PropertyPanel::present(const QStringList& pointers) {
    pinned_ = pointers;
    form_->setObjects(pointersOf(pointers));
    const std::string only = form_->objects().size() == 1 ? form_->objects().front() : std::string();
    strip_->setObject(only);
    stress_->setObject(only);
    showHeader();
    showFoot();
}

/// Shows help on the selected objects, until a field has the focus.
void PropertyPanel::showFoot() {
    const auto at = objectAt(*context_.document.scene(), form_->objects().front());
    if (!at) return;
    if (!subject_.isEmpty() && pinned_.isEmpty()) {
        helpTitle_->clear();
        return helpText_->setText(tr("Results at the time shown. Drag along the timeline to see other times."));
    }
    if (!form_->hasRows()) {
        helpTitle_->clear();
        return helpText_->setText(tr("Select objects of one kind to edit their fields together."));
    }
    helpTitle_->setText(QString("<b>%1</b>").arg(titleOf(*at->structure).toHtmlEscaped()));
    helpText_->setText(plainHelp(at->structure->help));
}

void PropertyPanel::addAbove(QWidget* widget) { page_->insertWidget(0, widget); }

void PropertyPanel::setSubject(const QString& title, const QString& detail) {
    subject_ = title;
    subjectDetail_ = detail;
    showHeader();
    showFoot();
}

void PropertyPanel::showHeader() {
    const bool hasFields = subject_.isEmpty() || !pinned_.isEmpty();
    form_->setVisible(hasFields);
    if (!subject_.isEmpty() && !pin_->isChecked()) {
        pin_->setIcon(context_.themes.icon("pin"));
        title_->setText(subject_);
        return detail_->setText(subjectDetail_);
    }
    const Scene& scene = *context_.document.scene();
    const auto& pointers = form_->objects();
    const auto at = objectAt(scene, pointers.front());
    const QIcon icon = context_.themes.icon("pin");
    pin_->setIcon(icon);
    if (!at) {
        title_->setText(tr("The selected object no longer exists"));
        return detail_->clear();
    }
    if (pointers.size() > 1) {
        const SelectionTitle several = selectionTitle(scene, pointers);
        title_->setText(several.title);
        return detail_->setText(several.detail);
    }
    const QString name = QString::fromStdString(nameAt(scene, pointers.front()));
    const QString kind = fromUtf8(at->structure->name);
    title_->setText(name.isEmpty() ? titleOf(*at->structure) : QString::fromUtf8("%1 · %2").arg(name, kind));
    detail_->setText(pointers.front().empty() ? context_.document.title()
                                              : detailOf(context_.document, context_.display, pointers.front()));
}

void PropertyPanel::showHelp(const FormRow& row) {
    const FieldHelp help = helpOf(row, context_);
    helpTitle_->setText(QString("<b>%1</b> %2").arg(help.name.toHtmlEscaped(), help.numbers.toHtmlEscaped()));
    helpText_->setText(help.text);
}

void PropertyPanel::focusPointer(const QString& pointer) {
    if (form_->objects().empty()) return;
    const std::string& object = form_->objects().front();
    const std::string field = pointer.toStdString();
    if (isWithin(field, object) && field.size() > object.size())
        focusField(QString::fromStdString(field.substr(object.size() + 1)));
}

bool PropertyPanel::focusField(const QString& path) {
    filter_->clear();
    return form_->focusField(path);
}

}  // namespace keyblock
