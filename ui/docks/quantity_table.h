// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quantities defined in the scene, as measured in the run, compared with the
// expected values given in the scene.
#pragma once

#include "solver/results/quantity.h"
#include "ui/document/background.h"

#include <QWidget>

#include <memory>
#include <vector>

class QLabel;
class QTreeWidget;

namespace keyblock {

class LiveRun;
class Themes;
class TimeCursor;

class QuantityTable : public QWidget {
    Q_OBJECT

public:
    QuantityTable(const Themes& themes, const TimeCursor& cursor, QWidget* parent = nullptr);
    ~QuantityTable() override;

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Reading;

    void read();
    void fill(const Reading& reading);
    void addExpected(const MeasuredComparison& comparison, bool isWhole);

    const Themes& themes_;
    const TimeCursor& cursor_;
    QLabel* hint_;
    QTreeWidget* list_;
    std::shared_ptr<const LiveRun> run_;  // run that was last read
    std::size_t rows_ = 0;  // number of its history rows when it was last read
    Background reader_;
};

}  // namespace keyblock
