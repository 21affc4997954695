// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy against time of the scene's numerical settings: the runs with their progress
// and a Stop button, the recommended preset, and the chart, in which a click on a dot
// uses its settings.
#pragma once

#include "ui/docks/trial_panel.h"

namespace keyblock {

class Document;
class Themes;
class TradeRuns;
class TradeView;

class AccuracyPanel : public TrialPanel {
    Q_OBJECT

public:
    AccuracyPanel(const Themes& themes, Document& document, TradeRuns& runs, QWidget* parent = nullptr);

private:
    void fill();
    QString answer() const;
    QString detail() const;
    /// Makes the settings of a point those of the scene, as one undo step.
    void use(int point);

    Document& document_;
    TradeRuns& runs_;
    TradeView* chart_;
    QString used_;  // settings used last
};

}  // namespace keyblock
