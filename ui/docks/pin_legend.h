// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pins in the dock of curves, one chip each, with a cross that unpins it.
#pragma once

#include <QWidget>

class QHBoxLayout;

namespace keyblock {

class Pins;
class Themes;

class PinLegend : public QWidget {
    Q_OBJECT

public:
    PinLegend(const Themes& themes, Pins& pins, QWidget* parent = nullptr);

private:
    void fill();

    const Themes& themes_;
    Pins& pins_;
    QHBoxLayout* row_;
};

}  // namespace keyblock
