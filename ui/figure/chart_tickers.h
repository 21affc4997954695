// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers on a chart's axes: our round ones instead of QCustomPlot's.
#pragma once

#include "ui/figure/ink.h"
#include "ui/picture/chart.h"

#include <qcustomplot.h>

#include <vector>

namespace keyblock {

/// Round numbers, with a true minus sign.
class RoundTicker : public QCPAxisTicker {
public:
    explicit RoundTicker(int most) : most_(most) {}
    /// Keeps them at least this fraction of the axis apart.
    void setLeast(double share) { least_ = share; }
    void generate(const QCPRange& range, const QLocale& locale, QChar format, int precision, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* labels) override;

private:
    Ticks ticksIn(const ValueRange& range) const;

    int most_;
    double least_ = 0.0;
};

/// Round times of each stage on an axis of that length [mm].
class StageTicker : public QCPAxisTicker {
public:
    StageTicker(const Chart& chart, double length);
    void generate(const QCPRange& range, const QLocale& locale, QChar format, int precision, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* labels) override;

private:
    std::vector<AxisTick> ticks_;
};

}  // namespace keyblock
