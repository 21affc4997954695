// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Editors for values that fit on one line: numbers, points and texts; choices; flags.
#pragma once

#include "ui/panels/editors/value_editor.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace keyblock {

/// Edits numbers, points, directions, positions and strings. Values are rounded for display; all digits are shown while
/// editing.
class LineEditor : public ValueEditor {
    Q_OBJECT

public:
    LineEditor(const FormRow& row, const FormContext& context, QWidget* parent);
    void present(const FormRow& row) override;
    bool isWide() const override { return wide_; }
    bool tellsUnit() const override { return isText_; }
    void setRefused(bool refused) override;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void enter();
    void showText(bool exact);

    FormContext context_;
    FormRow row_;
    QLineEdit* line_;
    QString shown_;  // text last set by the program
    bool wide_, isText_;
    bool refused_ = false;
};

/// Edits a field with a fixed set of values, or the name of another object.
class ChoiceEditor : public ValueEditor {
    Q_OBJECT

public:
    ChoiceEditor(const FormContext& context, QWidget* parent);
    void present(const FormRow& row) override;
    void setRefused(bool) override {}
    bool tellsUnit() const override { return true; }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    FormContext context_;
    FormRow row_;
    QComboBox* box_;
};

class FlagEditor : public ValueEditor {
    Q_OBJECT

public:
    explicit FlagEditor(QWidget* parent);
    void present(const FormRow& row) override;
    void setRefused(bool) override {}

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QCheckBox* box_;
};

}  // namespace keyblock
