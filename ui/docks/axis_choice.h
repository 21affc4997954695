// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses which quantity of a run is plotted against which: two boxes that find a name
// by a few of its letters, even in runs with hundreds of bolts.
#pragma once

#include <QWidget>

#include <string>

class QComboBox;

namespace keyblock {

class RunSource;

class AxisChoice : public QWidget {
    Q_OBJECT

public:
    explicit AxisChoice(QWidget* parent = nullptr);

    /// Offers the quantities of a run; the current choice stays if the new run has it too.
    void offer(const RunSource& run);
    /// Names as in `allSeries`; `x` is empty for time, `y` if there is nothing to choose.
    std::string y() const;
    std::string x() const;

Q_SIGNALS:
    void chosen();

private:
    QComboBox *y_, *x_;
};

}  // namespace keyblock
