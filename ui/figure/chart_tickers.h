// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ticks of the axes of a chart, at round numbers chosen as for legends and scale bars
// instead of by QCustomPlot.
#pragma once

#include "ui/figure/ink.h"
#include "ui/picture/chart.h"

#include <qcustomplot.h>

#include <vector>

namespace keyblock {

/// At most `most` ticks at round numbers. Negative numbers have a true minus sign.
class RoundTicker : public QCPAxisTicker {
public:
    explicit RoundTicker(int most) : most_(most) {}
    /// Sets the smallest distance between ticks, as a fraction of the length of the axis.
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
