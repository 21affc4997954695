// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An option of a tool as shown in the bar above the canvas. Most options are fields of
// the object that the tool is about to create, taken from the field table, so that
// unit, range and help are the same as in the file.
#pragma once

#include "solver/scene/field.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace keyblock {

struct ToolField {
    QString id;  // key of the field, or id of the option
    QString label;
    QString help;
    QString unit;  // SI unit as in the field table; empty: none
    QStringList choices{};  // allowed texts; empty: any
    bool isInteger = false;
    QString none{};  // meaning of an empty field, if it may be empty
    std::function<FieldValue()> get;
    std::function<QString(const FieldValue&)> set;  // returns why the value is refused; empty: accepted
    QStringList choiceTexts{};  // one text to show per choice; empty: the choices themselves are shown

    const QStringList& shownChoices() const { return choiceTexts.isEmpty() ? choices : choiceTexts; }
};

/// A tool option for the field `key` of `object`, which belongs to the scene's list `list` (`bolts`, `joint_sets`, …).
/// \param choices names allowed for a text field
/// \param changed called after every change
ToolField rowField(const char* list, const char* key, void* object, const QString& label, std::function<void()> changed,
                   const QStringList& choices = {});

/// True if the field `key` applies to `object`. The width, for example, does not apply to a circular tunnel.
/// \param list the scene's list to which the object belongs
bool rowApplies(const char* list, const char* key, const void* object);

/// A numerical option that is not in the field table. Setting a value outside `range` is refused.
ToolField numberField(const QString& id, const QString& label, const QString& help, const QString& unit,
                      const Range& range, double& value, std::function<void()> changed);

/// An option that is not in the field table: the index of one of `choices`.
ToolField choiceField(const QString& id, const QString& label, const QStringList& choices, int& chosen,
                      std::function<void()> changed);

}  // namespace keyblock
