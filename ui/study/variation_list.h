// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What varies in a study: a list of its parameters and faults, and next to it the fields
// of the selected one.
#pragma once

#include "ui/study/study_row.h"

#include <QWidget>

#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace keyblock {

class StudyDraft;
class Themes;

class VariationList : public QWidget {
    Q_OBJECT

public:
    VariationList(StudyDraft& draft, const Themes& themes, QWidget* parent = nullptr);

    /// Shows the study and its problems.
    void fill();
    /// Selects the parameter or fault at or above this pointer. \return false if there is none
    bool reveal(const std::string& pointer);

Q_SIGNALS:
    void entered(const std::string& pointer, const keyblock::FieldValue& value);

private:
    QWidget* makeList();
    QWidget* makeDetail();
    std::string selected() const;
    void showDetail();
    void buildRows();
    void add(const QString& what);
    void remove();
    void chooseKind(int choice);

    StudyDraft& draft_;
    const Themes& themes_;
    QTreeWidget* list_;
    QPushButton *add_, *remove_;
    QComboBox* kind_;
    QWidget *kindRow_, *detail_;
    QVBoxLayout* rows_;
    QLabel *empty_, *problem_;
    std::vector<StudyRow*> fields_;
    QString shape_;  // of the rows shown
};

}  // namespace keyblock
