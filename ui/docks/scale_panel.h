// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings for the colour scale of a quantity, opened from its colour bar in the
// legend: range of values, exclusion of extreme values, and number of colour steps.
// Every change takes effect at once.
#pragma once

#include "ui/picture/section/legend.h"
#include "ui/picture/section/shown_numbers.h"

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
    /// The panel deletes itself when it closes.
    /// \param bar the colour bar as shown in the legend
    /// \param clips whether extreme values can be excluded
    ScalePanel(const LegendBar& bar, const ShownNumbers& numbers, bool clips, ViewSettings& settings, QWidget* parent);

    /// Opens the panel with its upper right corner at `corner` on the screen, or shifted if there is not enough room.
    void openAt(const QPoint& corner);

private:
    void fill();
    void take();
    void takeTyped();
    void reset();
    QLineEdit* makeEnd(const char* name, const QString& title, double shown);
    std::optional<ValueRange> typed();

    LegendBar bar_;
    double factor_;  // display value = `factor_` × value of the bar
    ViewSettings& settings_;
    QRadioButton *all_, *frame_, *own_;
    QLineEdit *from_, *to_;
    QCheckBox* clip_;
    QComboBox* steps_;
};

}  // namespace keyblock
