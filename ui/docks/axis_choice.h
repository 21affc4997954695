// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which number of a run stands over which: two boxes that find a name by a few of
// its letters, for runs with hundreds of bolts too.
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

    /// Offers the numbers of a run; what was chosen stays where the run has it too.
    void offer(const RunSource& run);
    /// As `allSeries` calls them; `x` is empty for time, `y` where there is nothing to choose.
    std::string y() const;
    std::string x() const;

Q_SIGNALS:
    void chosen();

private:
    QComboBox *y_, *x_;
};

}  // namespace keyblock
