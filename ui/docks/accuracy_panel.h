// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against time of the scene's numerical settings: the runs with their progress
// and a Stop button, the recommended preset, and the chart, in which a click on a dot
// uses its settings.
#pragma once

#include <QWidget>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace keyblock {

class Document;
class Themes;
class TradeRuns;
class TradeView;

class AccuracyPanel : public QWidget {
    Q_OBJECT

public:
    AccuracyPanel(const Themes& themes, Document& document, TradeRuns& runs, QWidget* parent = nullptr);

protected:
    /// Puts the button below the text where there is little room next to it.
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    QString answer() const;
    QString detail() const;
    /// Makes the settings of a point those of the scene, as one undo step.
    void use(int point);

    Document& document_;
    TradeRuns& runs_;
    QLabel *answer_, *detail_;
    QBoxLayout* row_;
    QProgressBar* progress_;
    QPushButton *start_, *stop_;
    TradeView* chart_;
    QString used_;  // settings used last
};

}  // namespace keyblock
