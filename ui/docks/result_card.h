// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of the selected bolt or block at the time shown, as a group at the top of
// the Properties panel.
#pragma once

#include "ui/docks/result_rows.h"
#include "ui/document/background.h"

#include <QWidget>

#include <memory>

class QGridLayout;
class QLabel;

namespace keyblock {

class BlockChoice;
class BoltChoice;
class Display;
class Themes;
class TimeCursor;

class ResultCard : public QWidget {
    Q_OBJECT

public:
    ResultCard(const Themes& themes, const Display& display, TimeCursor& cursor, const BoltChoice& bolts,
               const BlockChoice& blocks, QWidget* parent = nullptr);
    ~ResultCard() override;

    /// Turns the results on or off; they are off while the window shows the drawing.
    void setOn(bool on);
    /// The report shown; null: none.
    const std::shared_ptr<const ResultReport>& report() const { return report_; }

Q_SIGNALS:
    /// Emitted when a different bolt or block is shown, or none. Both strings are empty if none is shown.
    void subjectChanged(const QString& title, const QString& detail);

private:
    void make();
    void show(std::shared_ptr<const ResultReport> report);
    void addRow(const ResultRow& row);
    void addEvents();

    const Themes& themes_;
    const Display& display_;
    TimeCursor& cursor_;
    const BoltChoice& bolts_;
    const BlockChoice& blocks_;
    std::shared_ptr<const ResultReport> report_;
    QWidget* rows_ = nullptr;
    QGridLayout* grid_ = nullptr;
    bool on_ = false;
    Background reading_;
};

}  // namespace keyblock
