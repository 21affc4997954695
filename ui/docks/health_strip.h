// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solver diagnostics at the time shown: one row per measure, with the block responsible
// for the worst value and advice.
#pragma once

#include "ui/runs/live_feed.h"

#include <QString>
#include <QWidget>

#include <array>
#include <optional>
#include <vector>

namespace keyblock {

class LiveRun;
class Themes;
class TimeCursor;

enum class HealthState { Unknown, Good, Warning, Bad };
enum class HealthMeasure { Passes, StepCuts, Penetration, Balance, Residual };
inline constexpr std::size_t healthMeasures = 5;

/// One diagnostic measure at one time.
struct HealthRow {
    HealthMeasure measure = HealthMeasure::Passes;
    HealthState state = HealthState::Unknown;
    std::optional<double> value;  // iterations, time-step reductions per 100 steps, or a fraction
    double limit = 0.0;
    int block = -1;  // block responsible for the value; −1: no particular block
    std::vector<double> course;  // values up to the time shown, for the sparkline
};

using HealthRows = std::array<HealthRow, healthMeasures>;

/// The diagnostic measures at a time within a stage, indexed by `HealthMeasure`. For a run opened from a file, the
/// measures refer to the whole stage instead.
/// \param time time since the start of the stage [s], or pseudo-time.
HealthRows healthAt(const LiveRun& run, int stage, double time);

class HealthStrip : public QWidget {
    Q_OBJECT

public:
    HealthStrip(const Themes& themes, TimeCursor& cursor, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override { return {280, 140}; }
    QSize sizeHint() const override { return {415, 214}; }

Q_SIGNALS:
    void blockAsked(int block, const QString& why);  // index among the solved blocks

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    void judge();
    void paintRow(QPainter& painter, const HealthRow& row, double y) const;
    void paintCourse(QPainter& painter, const HealthRow& row, const QRectF& box) const;
    void paintAdvice(QPainter& painter, double y);
    const HealthRow* worstRow() const;
    QString adviceOn(const HealthRow& row) const;
    QString nameOf(HealthMeasure measure) const;

    const Themes& themes_;
    TimeCursor& cursor_;
    HealthRows rows_;
    bool known_ = false;
    QRectF link_;  // rectangle of the link "Show block"
};

}  // namespace keyblock
