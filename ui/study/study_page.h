// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of studies: a header with the file, the buttons and the progress; below it
// either the form of the study or its results.
#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace keyblock {

class Commands;
class StudyDraft;
class StudyForm;
class StudyResults;
class SweepSession;
class Themes;

class StudyPage : public QWidget {
    Q_OBJECT

public:
    /// \pre the commands study.new, study.open, study.save, study.run, study.stop and study.report exist.
    StudyPage(StudyDraft& draft, SweepSession& session, const Commands& commands, const Themes& themes,
              QWidget* parent = nullptr);

    StudyForm& form() const { return *form_; }
    StudyResults& results() const { return *results_; }
    void showSetup();
    void showResults();
    /// Offers to recover a study that was not saved. \param what names it; empty: nothing to recover
    void offerRecovery(const QString& what);
    /// A message below the header; empty: none.
    void setNotice(const QString& text);

Q_SIGNALS:
    void recoveryAnswered(bool recovers);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeHeader(const Commands& commands);
    QWidget* makeEmpty(const Commands& commands);
    QWidget* makeRecovery();
    QPushButton* button(const Commands& commands, const char* id, const QString& text);
    void fill();
    void showProgress();

    StudyDraft& draft_;
    SweepSession& session_;
    QAction& save_;
    QLabel *title_, *progressText_, *notice_, *recoveryText_ = nullptr;
    QPushButton *setup_, *show_, *run_ = nullptr, *stop_ = nullptr;
    QProgressBar* progress_;
    QWidget *recovery_ = nullptr, *progressRow_, *header_ = nullptr;
    QStackedWidget* stack_;
    StudyForm* form_;
    StudyResults* results_;
    QString noticeText_;
};

}  // namespace keyblock
