// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small chart next to a table, e.g. of a steel or bond curve or a load history.
#pragma once

#include "solver/scene/scene.h"

#include <QWidget>

class QCustomPlot;

namespace keyblock {

class Themes;

class TableChart : public QWidget {
    Q_OBJECT

public:
    explicit TableChart(const Themes& themes, QWidget* parent = nullptr);

    /// Plots the table, with values in display units.
    /// \param across title of the horizontal axis, with the unit in brackets
    /// \param up title of the vertical axis, with the unit in brackets
    void present(const Table& shown, const QString& across, const QString& up);

private:
    void paintAxes();

    const Themes& themes_;
    QCustomPlot* plot_;
};

}  // namespace keyblock
