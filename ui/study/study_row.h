// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A row of the form of a study: label, editor and unit of one field of its table, with
// the errors of the field below.
#pragma once

#include "ui/study/study_values.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace keyblock {

class StudyRow : public QWidget {
    Q_OBJECT

public:
    /// \param place a field of the kind that the row will show. \param label empty: that of the table
    StudyRow(const std::string& pointer, const StudyPlace& place, const QString& label, QWidget* parent);

    const std::string& pointer() const { return pointer_; }
    /// Refers to the same field of another object of a list.
    void setPointer(const std::string& pointer) { pointer_ = pointer; }

    /// Shows the value, unless it is being typed; hides the row if the field does not apply.
    void present(const Study& study);
    void setUnit(const QString& unit);
    /// Text that an empty editor shows.
    void setHint(const QString& hint);
    /// Errors and warnings of the check; empty: none.
    void setProblems(const QString& problems, bool isError);
    void takeFocus();

Q_SIGNALS:
    void entered(const std::string& pointer, const keyblock::FieldValue& value);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeEditor(const Field& field);
    QString typed() const;
    void enter();
    void showProblem();
    void showText(const QString& text);
    void showEmpty();

    std::string pointer_;
    StudyPlace place_;
    QLabel *label_, *unit_, *problem_;
    QLineEdit* line_ = nullptr;
    QPlainTextEdit* lines_ = nullptr;
    QComboBox* words_ = nullptr;
    QCheckBox* flag_ = nullptr;
    QString shown_, refusal_, problems_;
    bool isError_ = false;
};

}  // namespace keyblock
