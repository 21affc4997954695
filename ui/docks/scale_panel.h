// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The choice of a colour scale for a quantity, opened from its bar in the legend: the
// range of values, whether extremes are excluded, and colour steps. Every change is
// shown at once.
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
    /// \param bar as shown. \param clips whether extreme values can be excluded. Deletes itself when it closes.
    ScalePanel(const LegendBar& bar, const ShownNumbers& numbers, bool clips, ViewSettings& settings, QWidget* parent);

    /// Opens with its upper right corner at a point of the screen, moved if the screen has no room there.
    void openAt(const QPoint& corner);

private:
    void fill();
    void take();
    void takeTyped();
    void reset();
    QLineEdit* makeEnd(const char* name, const QString& title, double shown);
    std::optional<ValueRange> typed();

    LegendBar bar_;
    double factor_;  // shown = factor · value in units of pictures
    ViewSettings& settings_;
    QRadioButton *all_, *frame_, *own_;
    QLineEdit *from_, *to_;
    QCheckBox* clip_;
    QComboBox* steps_;
};

}  // namespace keyblock
