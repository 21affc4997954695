// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of the run's history, one chart at a time, with the moment that is shown on
// it: load over displacement, monitors, debonded length, energies, pins, any number
// over any other; beside them those of a run that is compared.
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
    /// \param pins null: no pins and no choice of axes.
    Curves(const Themes& themes, const Display& display, TimeCursor& cursor, CurveKind kind, Pins* pins,
           QWidget* parent = nullptr);

    /// Another run whose curves stand beside, drawn broken; null: none.
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
    int asked_ = 0;  // readings, so that one that is overtaken is known
    std::shared_ptr<const CurveReading> read_;  // null before the first of a run
    std::shared_ptr<const LiveRun> other_, offered_;  // beside; whose numbers can be chosen
    QString otherName_;
    QString wanted_;  // the chart that a person chose, by name
    std::size_t pinCount_ = 0;
    Background reader_;
};

}  // namespace keyblock
