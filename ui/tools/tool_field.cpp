// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_field.h"

#include "ui/edit/values.h"
#include "ui/look/field_text.h"

#include <QCoreApplication>

#include <cassert>
#include <cmath>

namespace keyblock {
namespace {

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

const Structure& entriesOf(const char* list) { return findField(sceneStructure(), list)->children.structure(); }

}  // namespace

ToolField rowField(const char* list, const char* key, void* object, const QString& label, std::function<void()> changed,
                   const QStringList& choices) {
    const Field* row = findField(entriesOf(list), key);
    assert(row && row->get);
    ToolField field;
    field.id = textOf(key);
    field.label = label;
    field.help = textOf(row->help);
    const std::string range = rangeText(row->range);
    if (!range.empty()) field.help += " (" + textOf(range) + ")";
    field.unit = textOf(row->unit);
    field.choices = field.choiceTexts = choices;
    for (const std::string_view word : row->words) {
        field.choices << textOf(word);
        field.choiceTexts << choiceText(*row, word);
    }
    field.isInteger = row->kind == FieldKind::Integer;
    if (row->nullable) field.none = row->kind == FieldKind::Text ? QCoreApplication::translate("tools", "default")
                                                                    : QCoreApplication::translate("tools", "auto");
    if (row->nullable && !choices.isEmpty()) {
        field.choices.prepend(field.none);
        field.choiceTexts.prepend(field.none);
    }
    field.get = [row, object] { return row->get(object); };
    field.set = [row, object, changed = std::move(changed)](const FieldValue& value) {
        const std::string problem = valueProblem(*row, value);
        if (!problem.empty()) return textOf(problem);
        if (row->get(object) == value) return QString();
        row->set(object, value);
        changed();
        return QString();
    };
    return field;
}

bool rowApplies(const char* list, const char* key, const void* object) {
    const Structure& structure = entriesOf(list);
    return applies(structure, *findField(structure, key), object);
}

ToolField numberField(const QString& id, const QString& label, const QString& help, const QString& unit,
                      const Range& range, double& value, std::function<void()> changed) {
    ToolField field{id, label, help, unit, {}, false, {}, {}, {}};
    field.get = [&value] { return FieldValue(value); };
    field.set = [&value, range, changed = std::move(changed)](const FieldValue& given) {
        const auto* number = std::get_if<double>(&given);
        if (!number || !std::isfinite(*number)) return QCoreApplication::translate("tools", "Enter a number.");
        if (!contains(range, *number))
            return QCoreApplication::translate("tools", "Enter a number %1.").arg(textOf(rangeText(range)));
        value = *number;
        changed();
        return QString();
    };
    return field;
}

ToolField choiceField(const QString& id, const QString& label, const QStringList& choices, int& chosen,
                      std::function<void()> changed) {
    ToolField field{id, label, {}, {}, choices, false, {}, {}, {}};
    field.get = [&chosen, choices] { return FieldValue(choices.value(chosen).toStdString()); };
    field.set = [&chosen, choices, changed = std::move(changed)](const FieldValue& value) {
        const auto* text = std::get_if<std::string>(&value);
        const int index = text ? choices.indexOf(QString::fromStdString(*text)) : -1;
        if (index < 0) return QStringLiteral("?");
        if (index != chosen) {
            chosen = index;
            changed();
        }
        return QString();
    };
    return field;
}

}  // namespace keyblock
