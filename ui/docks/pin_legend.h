// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pins in the Curves dock, one chip per pin with a cross that removes the pin.
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
