// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stress test of the scene: its progress and a Stop button, what breaks first and
// what to set, and a list of all pushes.
#pragma once

#include <QWidget>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace keyblock {

class StressRuns;

class StressPanel : public QWidget {
    Q_OBJECT

public:
    explicit StressPanel(StressRuns& runs, QWidget* parent = nullptr);

protected:
    /// Puts the button below the text where there is little room next to it.
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    void fillPushes();
    QString answer() const;
    QString detail() const;

    StressRuns& runs_;
    QLabel *answer_, *detail_;
    QBoxLayout* row_;
    QProgressBar* progress_;
    QPushButton *start_, *stop_;
    QTreeWidget* pushes_;
};

}  // namespace keyblock
