// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The widget that edits one field, of a kind that fits the field. Invalid input
// stays in it, marked, until it is corrected or discarded.
#pragma once

#include "ui/panels/form_rows.h"

#include <QWidget>

namespace keyblock {

class Display;
class Document;
class Themes;

/// What editors and forms need from the window.
struct FormContext {
    Document& document;
    const Display& display;
    const Themes& themes;
};

class ValueEditor : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// Updates the value shown, but keeps text that is being typed.
    virtual void present(const FormRow& row) = 0;

    /// Needs its own line below the label.
    virtual bool isWide() const { return false; }

    /// Shows the unit itself, not in the unit column.
    virtual bool tellsUnit() const { return false; }

    /// Marks the content as refused, or removes the mark.
    virtual void setRefused(bool refused) = 0;

Q_SIGNALS:
    void entered(const keyblock::FieldValue& value);
    void refused(const QString& why);  // the input has no value
    void takenBack();  // the refused input is gone
    void focused();
};

/// The editor for the row's field, with an accessible name.
ValueEditor* makeValueEditor(const FormRow& row, const FormContext& context, QWidget* parent);

/// The value used if the field is null, in the units shown; empty if it is only known in a run.
QString automaticText(const FormRow& row, const FormContext& context);

/// What null means for the field: `auto (1)`, `automatic`, `unlimited`.
QString nullTextOf(const FormRow& row, const FormContext& context);

}  // namespace keyblock
