// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An option of a tool as the bar above the canvas shows it. Most are rows of the
// field table for the object that the tool is about to make, so that unit, range and
// help are those of the file.
#pragma once

#include "solver/scene/field.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace keyblock {

struct ToolField {
    QString id;  // key of the row, or of the option
    QString label;
    QString help;
    QString unit;  // SI, as in the table; empty: none
    QStringList choices{};  // not empty: the allowed texts
    bool isInteger = false;
    QString none{};  // meaning of an empty field, if it may be empty
    std::function<FieldValue()> get;
    std::function<QString(const FieldValue&)> set;  // empty, or why the value is refused
    QStringList choiceTexts{};  // as shown, one for each choice; empty: the choices themselves

    const QStringList& shownChoices() const { return choiceTexts.isEmpty() ? choices : choiceTexts; }
};

/// The row `key` of the entries of the scene's list `list` (`bolts`, `joint_sets`, …) for the entry `object`.
/// `choices` are the names allowed for a text. `changed` is called after every change.
ToolField rowField(const char* list, const char* key, void* object, const QString& label, std::function<void()> changed,
                   const QStringList& choices = {});

/// True if the row applies to the object (the width of a circle does not).
bool rowApplies(const char* list, const char* key, const void* object);

/// A numerical option that is not in the table; `set` refuses values out of the range.
ToolField numberField(const QString& id, const QString& label, const QString& help, const QString& unit,
                      const Range& range, double& value, std::function<void()> changed);

/// An option that is not in the table: one of `choices`, by index.
ToolField choiceField(const QString& id, const QString& label, const QStringList& choices, int& chosen,
                      std::function<void()> changed);

}  // namespace keyblock
