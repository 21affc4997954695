// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers on the axes of a chart, rounded by our rules instead of QCustomPlot's.
#pragma once

#include "ui/figure/ink.h"
#include "ui/picture/chart.h"

#include <qcustomplot.h>

#include <vector>

namespace keyblock {

/// Ticks at round numbers, written with a true minus sign. At most `most` ticks.
class RoundTicker : public QCPAxisTicker {
public:
    explicit RoundTicker(int most) : most_(most) {}
    /// Keeps ticks at least this fraction of the axis apart.
    void setLeast(double share) { least_ = share; }
    void generate(const QCPRange& range, const QLocale& locale, QChar format, int precision, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* labels) override;

private:
    Ticks ticksIn(const ValueRange& range) const;

    int most_;
    double least_ = 0.0;
};

/// Ticks at round times of each stage. \param length length of the axis [mm].
class StageTicker : public QCPAxisTicker {
public:
    StageTicker(const Chart& chart, double length);
    void generate(const QCPRange& range, const QLocale& locale, QChar format, int precision, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* labels) override;

private:
    std::vector<AxisTick> ticks_;
};

}  // namespace keyblock
