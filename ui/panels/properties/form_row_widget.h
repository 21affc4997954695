// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One row of a form: label, value, unit and reset arrow, with the error message below.
// Also the heading of a group of rows.
#pragma once

#include "ui/panels/editors/value_editor.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace keyblock {

class FormRowWidget : public QWidget {
    Q_OBJECT

public:
    FormRowWidget(const FormRow& row, const FormContext& context, QWidget* parent);

    /// Shows this row with its messages.
    /// \param problems messages of the check about this row.
    /// \param error true if at least one of the messages is an error, not only a warning.
    void present(const FormRow& row, const QString& problems, bool error);

    const FormRow& row() const { return row_; }
    ValueEditor& editor() const { return *editor_; }

    /// Shows below the field why the input was refused; an empty string removes the message.
    void setRefusal(const QString& why);

Q_SIGNALS:
    void entered(const keyblock::FieldValue& value);
    void resetAsked();
    void focused();
    void targetAsked();  // the user wants to see the object named in the field
    void varyAsked();  // the user wants to vary the field in a study

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void layOut();
    bool canVary() const;
    void showMenu(QLineEdit* line, const QPoint& place);
    void showProblem();
    void showTarget();

    FormContext context_;
    FormRow row_;
    ValueEditor* editor_;
    QLabel* label_;
    QLabel* unit_;
    QToolButton* reset_;
    QToolButton* target_;
    QLabel* problem_;
    QString refusal_, problems_;
    bool error_ = false;
};

class FormHeading : public QWidget {
    Q_OBJECT

public:
    FormHeading(const FormGroup& group, bool open, const FormContext& context, QWidget* parent);

    void present(const FormGroup& group);
    const FormGroup& group() const { return group_; }

Q_SIGNALS:
    void toggled(bool open);
    void addAsked(const QString& pointer);
    void removeAsked(const QString& pointer);

protected:
    void mousePressEvent(QMouseEvent* event) override;

private:
    void paintFold();

    FormContext context_;
    FormGroup group_;
    bool open_;
    QToolButton* fold_;
    QLabel* title_;
    QLabel* detail_;
    QToolButton* add_;
    QToolButton* remove_;
};

}  // namespace keyblock
