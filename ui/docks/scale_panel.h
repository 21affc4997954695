// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The choice of a scale for the colours of a quantity, opened from its bar in the
// legend: which values the colours span, whether extreme ones are left out, and
// steps of colour. Every change is shown at once.
#pragma once

#include "ui/picture/legend.h"
#include "ui/picture/shown_numbers.h"

#include <QFrame>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QRadioButton;

namespace keyblock {

class ViewSettings;

class ScalePanel : public QFrame {
    Q_OBJECT

public:
    /// \param bar as it is shown. \param clips whether extreme values can be left out. Deletes itself when it closes.
    ScalePanel(const LegendBar& bar, const ShownNumbers& numbers, bool clips, ViewSettings& settings, QWidget* parent);

    /// Opens with its right upper corner at a point of the screen, as far as the screen has room.
    void openAt(const QPoint& corner);

private:
    void fill();
    void take();
    void takeTyped();
    void reset();
    QLineEdit* makeEnd(const char* name, const QString& title, double shown);
    std::optional<ValueRange> typed();

    LegendBar bar_;
    double factor_;  // shown = factor · as pictures are made
    ViewSettings& settings_;
    QRadioButton *all_, *frame_, *own_;
    QLineEdit *from_, *to_;
    QCheckBox* clip_;
    QComboBox* steps_;
};

}  // namespace keyblock
