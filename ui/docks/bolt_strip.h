// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolt diagram of one bolt at the time shown: the state of its bond as a band with
// the moving debonding front, and below it forces, bond and slip along the bolt on a
// common axis.
#pragma once

#include "ui/document/background.h"
#include "ui/picture/charts/bolt_chart.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QMenu;
class QToolButton;

namespace keyblock {

class BoltChoice;
class ChartView;
class Display;
class LiveRun;
class Themes;
class TimeCursor;

class BoltStrip : public QWidget {
    Q_OBJECT

public:
    BoltStrip(const Themes& themes, const Display& display, TimeCursor& cursor, BoltChoice& choice,
              QWidget* parent = nullptr);
    ~BoltStrip() override;

    QSize sizeHint() const override { return {740, 214}; }
    /// Title of the bolt shown, e.g. "B6 · rebar 20 · 2.40 m"; empty if none is shown.
    QString title() const;

Q_SIGNALS:
    void titleChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// History of the bolt so far. Only one thread may extend it.
    struct Past;
    struct Shown {
        BoltChart chart;
        std::vector<std::pair<double, std::string>> blocks;  // position along the bolt [m] and name of the block
        QString name, type, use;  // use: utilisation of the governing strength in the run so far
    };

    void runChanged();
    void make();
    void showNothing(const QString& why);
    void take(std::shared_ptr<const Shown> shown);
    void fillMenu(QMenu& menu);
    void paintBand(QPainter& painter) const;
    void paintBlocks(QPainter& painter) const;
    void paintFronts(QPainter& painter) const;

    const Themes& themes_;
    const Display& display_;
    TimeCursor& cursor_;
    BoltChoice& choice_;
    ChartView* view_;
    QToolButton* more_;
    std::size_t panels_ = 0;  // index of the chosen set of panels
    std::shared_ptr<Past> past_;
    std::shared_ptr<const Shown> shown_;
    QElapsedTimer made_;
    QTimer later_;
    Background painting_;
};

}  // namespace keyblock
