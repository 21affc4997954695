// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page on which a study is made: its scene, how the cases are chosen, what varies,
// the results of interest and what counts as failure. Errors are shown at their fields.
#pragma once

#include "ui/study/study_row.h"

#include <QScrollArea>

#include <vector>

class QLabel;
class QListWidget;
class QVBoxLayout;

namespace keyblock {

class StudyDraft;
class Themes;
class VariationList;

class StudyForm : public QScrollArea {
    Q_OBJECT

public:
    StudyForm(StudyDraft& draft, const Themes& themes, QWidget* parent = nullptr);

    /// Shows the field at this pointer and moves the focus to it.
    void reveal(const std::string& pointer);

private:
    void addTitle(const QString& text);
    void addRow(const std::string& pointer, const QString& label = {}, const QString& hint = {});
    void fill();
    void showProblems();
    void enter(const std::string& pointer, const FieldValue& value);

    StudyDraft& draft_;
    QWidget* page_;
    QVBoxLayout* column_;
    QLabel *scene_, *sceneNote_, *count_, *problemTitle_;
    VariationList* variations_;
    QListWidget* problems_;
    std::vector<StudyRow*> rows_;
};

}  // namespace keyblock
