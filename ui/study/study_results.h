// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of a study while it runs and afterwards: probability of failure, charts, and
// the table of cases, from which each can be opened.
#pragma once

#include "ui/study/sweep_session.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace keyblock {

class CaseTableModel;
class SweepView;
class Themes;

class StudyResults : public QWidget {
    Q_OBJECT

public:
    StudyResults(SweepSession& session, const Themes& themes, QWidget* parent = nullptr);

    /// Number of the selected case; 0: none.
    long selectedCase() const { return case_; }

    /// Whether the study or its scene has changed since the cases were planned.
    void setStale(bool isStale);

Q_SIGNALS:
    void caseWanted(long number);  // the user wants to see the scene of this case
    void runWanted(long number);  // and its run

private:
    enum class ChartKind { Distribution, Scatter, Influence, Convergence };

    QWidget* makeCharts();
    QWidget* makeCases();
    QComboBox* addChoice(const char* name, const QString& title);
    void fill();
    void fillChoices();
    void chooseResult();
    static bool isMeasured(const SweepColumn& column);
    void showAnswer();
    void showChart();
    void selectCase(long number);
    void showCase();
    const SweepColumn* chosen(const QComboBox& box) const;

    SweepSession& session_;
    const Themes& themes_;
    QLabel *answer_, *detail_, *caseText_;
    QComboBox *kind_, *result_, *against_;
    QLabel* againstText_;
    SweepView* chart_;
    CaseTableModel* model_;
    QSortFilterProxyModel* sorted_;
    QTableView* table_;
    QPushButton *openCase_, *openRun_;
    long case_ = 0;
    bool isStale_ = false, choosesResult_ = false;
};

}  // namespace keyblock
