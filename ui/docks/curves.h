// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of a run, one chart at a time, with the current time marked:
// load–displacement curves, monitors, debonded length, energies, pins, or any quantity
// against any other. The curves of a second run are added if two runs are compared.
#pragma once

#include "ui/docks/curve_entries.h"
#include "ui/document/background.h"

#include <QTimer>
#include <QWidget>

class QComboBox;

namespace keyblock {

class AxisChoice;
class ChartView;
class Display;
class LiveRun;
class Pins;
class Themes;
class TimeCursor;

class Curves : public QWidget {
    Q_OBJECT

public:
    /// \param pins pinned points; null: pins and the choice of quantities are not available
    Curves(const Themes& themes, const Display& display, TimeCursor& cursor, CurveKind kind, Pins* pins,
           QWidget* parent = nullptr);

    /// Sets a second run, whose curves are added as dashed lines; null: none.
    void setOther(std::shared_ptr<const LiveRun> other, const QString& name);

    QSize sizeHint() const override { return {445, 214}; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeChoices();
    void runChanged();
    void grow();
    void read();
    void take(std::shared_ptr<const CurveReading> reading, int took);
    void fillChoice();
    void captionChoice();
    void choose();
    void showPinned();
    CurveEntry withOther(CurveEntry entry) const;
    bool choosesAxes() const;
    void showNow();
    void jump(double x);
    const CurveEntry* current() const;

    const Display& display_;
    TimeCursor& cursor_;
    CurveKind kind_;
    Pins* pins_;
    QComboBox* choice_;
    AxisChoice* axes_ = nullptr;
    ChartView* view_;
    QTimer timer_;
    bool stale_ = true, reads_ = false;
    int asked_ = 0;  // number of readings started, to recognise results that are out of date
    std::shared_ptr<const CurveReading> read_;  // null until the first reading of a run has finished
    std::shared_ptr<const LiveRun> other_, offered_;  // second run; run whose quantities are offered
    QString otherName_;
    QString wanted_;  // name of the chart chosen by the user
    std::size_t pinCount_ = 0;
    Background reader_;
};

}  // namespace keyblock
