// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editors/stress_strip.h"

#include "ui/document/document.h"
#include "ui/edit/stress_edit.h"
#include "ui/look/display.h"
#include "ui/panels/calm_box.h"
#include "ui/panels/fields/value_text.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QVariant>
#include <QVBoxLayout>

namespace keyblock {

namespace {

enum Index { Surface, Weight, Ratio, Major, Minor, Angle };  // of the fields

}  // namespace

StressStrip::StressStrip(const FormContext& context, QWidget* parent)
    : QWidget(parent), context_(context), way_(new CalmBox(this)), form_(new QFormLayout), problem_(new QLabel(this)) {
    setObjectName("stressStrip");
    auto* heading = new QLabel(tr("Calculate from"), this);
    heading->setProperty("role", "title");
    way_->addItems({tr("Depth and K0"), tr("σ1, σ3 and angle")});
    way_->setObjectName("stress.way");
    way_->setAccessibleName(tr("Input method for the in-situ stress"));
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setVerticalSpacing(4);
    addField(Way::Depth, "stress.surface", "m");
    addField(Way::Depth, "stress.weight", "N/m³");
    addField(Way::Depth, "stress.k0", "");
    addField(Way::Principal, "stress.major", "Pa");
    addField(Way::Principal, "stress.minor", "Pa");
    addField(Way::Principal, "stress.angle", "°");
    nameFields();
    problem_->setProperty("role", "problem");
    problem_->setWordWrap(true);
    problem_->hide();
    auto* fillIn = new QPushButton(tr("Calculate in-situ stress"), this);
    fillIn->setObjectName("stress.apply");
    fillIn->setAccessibleName(fillIn->text());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 10);
    column->setSpacing(6);
    column->addWidget(heading);
    column->addWidget(way_);
    column->addLayout(form_);
    column->addWidget(problem_);
    column->addWidget(fillIn);
    connect(way_, QOverload<int>::of(&QComboBox::activated), this, &StressStrip::showWay);
    connect(fillIn, &QPushButton::clicked, this, &StressStrip::apply);
    connect(&context.display, &Display::changed, this, &StressStrip::fill);
    connect(&context.document, &Document::changed, this, [this] {
        if (isVisible()) fill();
    });
    nameFields();
    hide();
}

void StressStrip::addField(Way way, const char* id, const char* unit) {
    auto* editor = new QLineEdit(this);
    editor->setObjectName(id);
    editor->setAlignment(Qt::AlignRight);
    connect(editor, &QLineEdit::returnPressed, this, &StressStrip::apply);
    auto* name = new QLabel(this);
    name->setProperty("role", "detail");
    name->setBuddy(editor);
    form_->addRow(name, editor);
    fields_.push_back({editor, name, unit, way});
}

void StressStrip::setObject(const std::string& pointer) {
    const bool isShown = pointer == "/in_situ_stress";
    setVisible(isShown);
    if (isShown) fill();
}

/// Fills the input fields from the scene, in the units and the sign convention shown.
void StressStrip::fill() {
    const Scene& scene = *context_.document.scene();
    const DepthStress depth = suggestedDepthStress(scene);
    const PrincipalStresses principal = principalStressesOf(scene);
    const double sign = context_.display.compressionPositive() ? 1.0 : -1.0;
    setValue(Surface, depth.surfaceY);
    setValue(Weight, depth.unitWeight);
    setValue(Ratio, depth.k0);
    setValue(Major, sign * principal.major);
    setValue(Minor, sign * principal.minor);
    setValue(Angle, principal.angle);
    nameFields();
    showWay();
}

void StressStrip::nameFields() {
    const QString sign = context_.display.compressionPositive() ? tr("compression +") : tr("tension +");
    const QStringList names{tr("Ground surface elevation"), tr("Unit weight"), tr("K0 = σh / σv"),
                            tr("σ1, %1").arg(sign), tr("σ3, %1").arg(sign), tr("Angle of σ1 from x axis")};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const QString unit = context_.display.shown(fields_[i].unit).symbol;
        fields_[i].name->setText(unit.isEmpty() ? names[int(i)] : tr("%1 [%2]").arg(names[int(i)], unit));
        fields_[i].editor->setAccessibleName(fields_[i].name->text());
    }
}

void StressStrip::showWay() {
    for (const Field& field : fields_) {
        const bool isShown = static_cast<int>(field.way) == way_->currentIndex();
        field.editor->setVisible(isShown);
        field.name->setVisible(isShown);
    }
    problem_->hide();
}

void StressStrip::setValue(std::size_t field, double value) {
    fields_[field].editor->setText(numberText(value, fields_[field].unit, context_.display));
    fields_[field].editor->setCursorPosition(0);
}

/// Reads the number in a field, and marks the field if its text is not a number.
std::optional<double> StressStrip::valueOf(std::size_t field) {
    QLineEdit& editor = *fields_[field].editor;
    const auto typed = readNumber(editor.text(), fields_[field].unit, context_.display);
    editor.setProperty("invalid", !typed.value);
    editor.style()->unpolish(&editor);
    editor.style()->polish(&editor);
    if (!typed.value) problem_->setText(typed.problem);
    return typed.value;
}

void StressStrip::apply() {
    const bool byDepth = way_->currentIndex() == static_cast<int>(Way::Depth);
    const std::size_t first = byDepth ? Surface : Major;
    const auto a = valueOf(first), b = valueOf(first + 1), c = valueOf(first + 2);
    if (!a || !b || !c) return problem_->show();
    const Scene& scene = *context_.document.committed();
    const double sign = context_.display.compressionPositive() ? 1.0 : -1.0;
    Edit edit = byDepth ? withDepthStress(scene, {*a, *b, *c}) : withPrincipalStresses(scene, {sign * *a, sign * *b, *c});
    problem_->setText(QString::fromStdString(edit.refusal));
    problem_->setVisible(!edit.done());
    if (!edit.done()) return;
    context_.document.apply(byDepth ? tr("In-situ stress from depth and K0") : tr("In-situ stress from σ1 and σ3"),
                            std::move(edit));
}

}  // namespace keyblock
