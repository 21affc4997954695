// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The workflow bar at the top of the window: one tab per step, with a tick, a warning
// or a cross. The bar shows the state of each step but does not enforce an order.
#pragma once

#include "ui/window/workflow.h"

#include <QWidget>

#include <array>

class QHBoxLayout;
class QToolButton;

namespace keyblock {

class Themes;

class WorkflowBar : public QWidget {
    Q_OBJECT

public:
    explicit WorkflowBar(const Themes& themes, QWidget* parent = nullptr);

    WorkStep current() const { return current_; }
    void choose(WorkStep step);
    void setStates(const WorkStates& states);

    /// Adds a widget at the right end of the bar, to the right of the widgets added before.
    void addRight(QWidget* widget);

    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void chosen(keyblock::WorkStep step);
    void asked(keyblock::WorkStep step);  // the user clicked this step, current or not

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void showIcons();
    void fit();

    const Themes& themes_;
    QHBoxLayout* row_;
    QWidget* right_ = nullptr;
    std::array<QToolButton*, workSteps> tabs_{};
    WorkStates states_{};
    WorkStep current_ = WorkStep::Geometry;
};

}  // namespace keyblock
