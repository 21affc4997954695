// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/value_editor.h"

#include "solver/scene/enum_names.h"
#include "ui/document/document.h"
#include "ui/panels/field_choices.h"
#include "ui/panels/field_words.h"
#include "ui/panels/line_editor.h"
#include "ui/panels/table_editor.h"

#include <algorithm>
#include <numbers>

namespace keyblock {

namespace {

constexpr std::size_t mostTicks = 40;  // names to tick; longer lists are typed

QString number(double value, const FormRow& row, const FormContext& context) {
    return numberText(value, unitOf(row.at, *row.field), context.display, 3);
}

QString firstJointMaterial(const Scene& scene) {
    return scene.jointMaterials.empty() ? QString() : QString::fromStdString(scene.jointMaterials.front().first);
}

/// Joints and sets use that of the domain; the domain and blocks the first of the scene.
QString automaticJointMaterial(const FormRow& row, const Scene& scene) {
    const bool ownFaces = row.structure->name == "domain" || row.structure->name == "block";
    if (!ownFaces && scene.domain && scene.domain->jointMaterial)
        return QString::fromStdString(*scene.domain->jointMaterial);
    return firstJointMaterial(scene);
}

/// From the last cut.
QString cutLimit(const FormRow& row, const FormContext& context) {
    const auto& cut = context.document.checked().cut;
    if (!cut) return {};
    const double value = row.field->key == "tolerance" ? cut->tolerance
                         : row.field->key == "min_area" ? cut->minArea : cut->minWidth;
    return number(value, row, context);
}

QString automaticOfStage(const FormRow& row, const Scene& scene, const FormContext& context) {
    if (row.field->key == "integration")
        return fromUtf8(wordsOf(scene.analysis.integration)[static_cast<std::size_t>(scene.analysis.integration)]);
    if (row.field->key == "rho_inf") return number(scene.analysis.rhoInf, row, context);
    return {};
}

QString automaticOfSteel(const FormRow& row, const FormContext& context) {
    const auto diameter = valueOf(*row.structure, row.at.object, "diameter");
    const auto steel = valueOf(*row.structure, row.at.object, "steel");
    const auto* d = std::get_if<double>(&diameter);
    const auto* curve = std::get_if<Table>(&steel);
    if (row.field->key == "area" && d) return number(std::numbers::pi * *d * *d / 4.0, row, context);
    if (!curve || curve->size() < 2) return {};
    if (row.field->key == "tensile_strength")
        return number(std::ranges::max(*curve, {}, [](const auto& point) { return point.second; }).second, row,
                      context);
    const auto& [strain, stress] = (*curve)[1];
    return row.field->key == "youngs_modulus" && strain > 0.0 ? number(stress / strain, row, context) : QString();
}

ValueEditor* editorOf(const FormRow& row, const FormContext& context, QWidget* parent) {
    switch (row.field->kind) {
        case FieldKind::Flag: return new FlagEditor(parent);
        case FieldKind::Word: return new ChoiceEditor(context, parent);
        case FieldKind::Points:
        case FieldKind::PointPair:
        case FieldKind::Pairs:
        case FieldKind::TextMap: return new TableEditor(row, context, parent);
        default: break;
    }
    const auto names = choicesOf(*context.document.scene(), *row.field);
    if (row.field->kind == FieldKind::TextList && names && names->size() <= mostTicks)
        return new NamesEditor(context, parent);
    if (row.field->kind == FieldKind::TextList) return new TableEditor(row, context, parent);
    if (names) return new ChoiceEditor(context, parent);
    return new LineEditor(row, context, parent);
}

}  // namespace

ValueEditor* makeValueEditor(const FormRow& row, const FormContext& context, QWidget* parent) {
    ValueEditor* editor = editorOf(row, context, parent);
    editor->setObjectName(QString::fromStdString(row.path));
    QWidget* inner = editor->focusProxy() ? editor->focusProxy() : editor;
    inner->setAccessibleName(labelOf(*row.field));
    inner->setAccessibleDescription(fromUtf8(row.field->help));
    return editor;
}

QString automaticText(const FormRow& row, const FormContext& context) {
    const Scene& scene = *context.document.scene();
    const std::string_view key = row.field->key;
    if (key == "spacing_out_of_plane") return number(scene.analysis.thickness, row, context);
    if (key == "joint_material") return automaticJointMaterial(row, scene);
    if (key == "region") return scene.domain ? QObject::tr("whole domain") : QString();
    if (row.structure->name == "cutting") return cutLimit(row, context);
    if (row.structure->name == "stage") return automaticOfStage(row, scene, context);
    if (row.structure->name == "bolt type") return automaticOfSteel(row, context);
    if (key == "residual_friction_angle" && row.structure->name == "joint material") {
        const FieldValue peak = valueOf(*row.structure, row.at.object, "friction_angle");
        return number(std::get<double>(peak), row, context);
    }
    if (key == "unbalanced") return number(std::min(1e-4, scene.analysis.tolerance), row, context);
    if (key == "body") return number(1e-3, row, context);
    if (key == "max_steps") return number(400, row, context);
    return {};
}

}  // namespace keyblock
