// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of the run's history, one chart at a time, with the moment that is shown on
// it: load over displacement, monitors, debonded length, energies.
#pragma once

#include "ui/picture/chart.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QComboBox;

namespace keyblock {

class ChartView;
class Themes;
class TimeCursor;

enum class CurveKind { All, Energies };

class Curves : public QWidget {
    Q_OBJECT

public:
    Curves(const Themes& themes, TimeCursor& cursor, CurveKind kind, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {445, 214}; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// A chart of one panel, with the whole first curve before it is thinned.
    struct Entry {
        QString name;
        Chart chart;
        std::vector<double> x, y;
    };

    void runChanged();
    void read();
    void choose();
    void showNow();
    void jump(double x);
    const Entry* current() const;

    TimeCursor& cursor_;
    CurveKind kind_;
    QComboBox* choice_;
    ChartView* view_;
    QTimer timer_;
    bool stale_ = true;
    std::vector<Entry> entries_;
    QString problem_;
    QString wanted_;  // the chart that a person chose, by name
};

}  // namespace keyblock
