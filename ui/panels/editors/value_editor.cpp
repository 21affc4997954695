// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editors/value_editor.h"

#include "ui/document/document.h"
#include "ui/look/field_text.h"
#include "ui/panels/editors/line_editor.h"
#include "ui/panels/editors/table_editor.h"
#include "ui/panels/fields/field_choices.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/value_text.h"

namespace keyblock {

namespace {

constexpr std::size_t mostTicks = 40;  // names with check boxes; longer lists are typed

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
    const auto& cut = context.document.checked().cut;
    const FieldValue value =
        automaticOf(*row.field, *context.document.scene(), cut ? &*cut : nullptr, row.at.object);
    if (const auto* word = std::get_if<std::string>(&value); word && row.field->kind == FieldKind::Word)
        return choiceText(*row.field, *word);
    if (const auto* name = std::get_if<std::string>(&value)) return QString::fromStdString(*name);
    const auto* number = std::get_if<double>(&value);
    return number ? numberText(*number, unitOf(row.at, *row.field), context.display, 3) : QString();
}

QString nullTextOf(const FormRow& row, const FormContext& context) {
    if (!row.field->nullText.empty()) return shownText(row.field->nullText);
    const QString automatic = automaticText(row, context);
    return automatic.isEmpty() ? ValueEditor::tr("automatic") : ValueEditor::tr("auto (%1)").arg(automatic);
}

}  // namespace keyblock
