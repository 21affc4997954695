// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Base class of the widgets that edit one field. Invalid input stays in the widget,
// marked, until it is corrected or discarded.
#pragma once

#include "ui/panels/fields/form_rows.h"

#include <QWidget>

namespace keyblock {

class Display;
class Document;
class Themes;

/// Objects of the window that editors and forms use.
struct FormContext {
    Document& document;
    const Display& display;
    const Themes& themes;
};

class ValueEditor : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// Updates the value shown, but keeps text that the user is typing.
    virtual void present(const FormRow& row) = 0;

    /// True if the editor needs its own line below the label.
    virtual bool isWide() const { return false; }

    /// True if the editor shows the unit itself, so that the unit column stays empty.
    virtual bool tellsUnit() const { return false; }

    /// Marks the content as refused, or removes the mark.
    virtual void setRefused(bool refused) = 0;

Q_SIGNALS:
    void entered(const keyblock::FieldValue& value);
    void refused(const QString& why);  // why the input cannot be read as a value
    void takenBack();  // the refused input was discarded
    void focused();
};

/// Creates the editor for the field of the row, with an accessible name.
ValueEditor* makeValueEditor(const FormRow& row, const FormContext& context, QWidget* parent);

/// The value that is used if the field is null, in display units; empty if it is known only during a run.
QString automaticText(const FormRow& row, const FormContext& context);

/// Text that the field shows if its value is null, e.g. `auto (1)`, `automatic` or `unlimited`.
QString nullTextOf(const FormRow& row, const FormContext& context);

}  // namespace keyblock
