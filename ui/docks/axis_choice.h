// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chooses the two quantities of a curve: two boxes that find a name by a few of its
// letters, even in a run with hundreds of bolts.
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

    /// Lists the quantities of a run. The current choice is kept if the new run has the same quantities.
    void offer(const RunSource& run);
    /// Names of the quantities on the two axes, as in `allSeries`. `x()` is empty for time; `y()` is empty if there is
    /// no quantity to choose.
    std::string y() const;
    std::string x() const;

Q_SIGNALS:
    void chosen();

private:
    QComboBox *y_, *x_;
};

}  // namespace keyblock
