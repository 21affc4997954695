// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows whether the section is stable in the run, which blocks are unstable, and the
// utilisation of each bolt. A click on a block outlines it; a click on a bolt selects
// it.
#pragma once

#include "solver/results/bolt_use.h"
#include "solver/results/verdict.h"
#include "ui/document/background.h"
#include "ui/picture/charts/bolt_report.h"

#include <QTimer>
#include <QWidget>

#include <memory>

class QLabel;
class QTreeWidget;

namespace keyblock {

class BoltChoice;
class Display;
class LiveRun;
class Themes;
class TimeCursor;

/// A bolt in the last frame: its state and the energy that it has absorbed [J].
struct BoltEnd {
    BoltCondition condition = BoltCondition::NotInstalled;
    double elastic = 0.0, plastic = 0.0, bond = 0.0;
};

class StabilityPanel : public QWidget {
    Q_OBJECT

public:
    StabilityPanel(const Themes& themes, const Display& display, TimeCursor& cursor, BoltChoice& choice,
                   QWidget* parent = nullptr);

    QSize sizeHint() const override { return {415, 214}; }

Q_SIGNALS:
    void blockAsked(int block, const QString& how);  // index among the solved blocks

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void takeRun();
    void takeGrowth();
    void readBolts();
    void fill();
    void fillVerdict();
    void fillBlocks(const Verdict& verdict);
    void fillBolts();
    QString peakText(const BoltPeak& peak, const char* unit, double axial) const;
    QString energyText(double joules) const;
    QString whenText(const BoltPeak& peak) const;
    QString namesOf(const std::vector<int>& blocks) const;

    const Themes& themes_;
    const Display& display_;
    TimeCursor& cursor_;
    QLabel* answer_;
    QLabel* worst_;
    QTreeWidget* blocks_;
    QTreeWidget* bolts_;
    std::shared_ptr<const LiveRun> run_;  // null: no run is shown
    QTimer growth_;  // until the panel shows what a growing run has added
    std::size_t read_ = 0;  // number of frames of the run when its bolts were last read
    std::vector<BoltUse> uses_;  // in the run so far, highest utilisation first
    std::vector<BoltEnd> ends_;  // one per bolt
    Background reader_;  // last member: destroyed before the data to which it delivers results
};

}  // namespace keyblock
