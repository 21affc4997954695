// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Editors for values that fit on one line (numbers, points, texts), for choices and
// for flags.
#pragma once

#include "ui/panels/value_editor.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace keyblock {

/// Numbers, points, directions, positions and texts. Shown rounded, edited exactly.
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
    QString shown_;  // as last set by the program
    bool wide_, isText_;
    bool refused_ = false;
};

/// Words, and names of other objects.
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
