// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small chart next to a table: steel and bond curves, loads over time.
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

    /// Values as shown; titles with their units in brackets.
    void present(const Table& shown, const QString& across, const QString& up);

private:
    void paintAxes();

    const Themes& themes_;
    QCustomPlot* plot_;
};

}  // namespace keyblock
