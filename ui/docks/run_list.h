// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of the document: open, go on with, remove.
#pragma once

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace keyblock {

class Runs;
class Themes;

class RunList : public QWidget {
    Q_OBJECT

public:
    RunList(const Themes& themes, Runs& runs, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {415, 214}; }

private:
    void fill();
    void showMenu(const QPoint& at);

    const Themes& themes_;
    Runs& runs_;
    QLabel* stale_;
    QTreeWidget* list_;
};

}  // namespace keyblock
