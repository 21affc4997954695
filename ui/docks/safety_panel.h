// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The factor of safety: the search with its progress and a Stop button, the bracket
// found, and the blocks that fail.
#pragma once

#include "ui/docks/trial_panel.h"

class QTreeWidget;

namespace keyblock {

class SafetySearch;

class SafetyPanel : public TrialPanel {
    Q_OBJECT

public:
    explicit SafetyPanel(SafetySearch& search, QWidget* parent = nullptr);

private:
    void fill();
    void fillRuns();
    QString answer() const;
    QString failure() const;

    SafetySearch& search_;
    QTreeWidget* runs_;
};

}  // namespace keyblock
