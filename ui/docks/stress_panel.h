// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stress test of the scene: its progress and a Stop button, what breaks first and
// what to set, and a list of all pushes.
#pragma once

#include "ui/docks/trial_panel.h"

class QTreeWidget;

namespace keyblock {

class StressRuns;

class StressPanel : public TrialPanel {
    Q_OBJECT

public:
    explicit StressPanel(StressRuns& runs, QWidget* parent = nullptr);

private:
    void fill();
    void fillPushes();
    QString answer() const;
    QString detail() const;

    StressRuns& runs_;
    QTreeWidget* pushes_;
};

}  // namespace keyblock
