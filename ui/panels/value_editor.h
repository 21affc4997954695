// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The widget in which a person edits one field, of a kind that fits the field. What
// is typed wrong stays in it, marked, until it is mended or taken back.
#pragma once

#include "ui/panels/form_rows.h"

#include <QWidget>

namespace keyblock {

class Display;
class Document;
class Themes;

/// What editors and forms need of the window.
struct FormContext {
    Document& document;
    const Display& display;
    const Themes& themes;
};

class ValueEditor : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// Shows the row's value anew, but leaves what a person is just typing.
    virtual void present(const FormRow& row) = 0;

    /// Takes a line of its own below the label.
    virtual bool isWide() const { return false; }

    /// The unit is told inside, not in the unit column.
    virtual bool tellsUnit() const { return false; }

    /// Marks what stands in it as not taken, or takes the mark off.
    virtual void setRefused(bool refused) = 0;

Q_SIGNALS:
    void entered(const keyblock::FieldValue& value);
    void refused(const QString& why);  // what was typed has no value
    void takenBack();  // what was refused is no longer there
    void focused();
};

/// The editor for the row's field, named for people who cannot see it.
ValueEditor* makeValueEditor(const FormRow& row, const FormContext& context, QWidget* parent);

/// What the program takes where the field is null, in the units shown; empty where it decides only in a run.
QString automaticText(const FormRow& row, const FormContext& context);

}  // namespace keyblock
