// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of the document, with the commands to open, resume, compare and remove them.
#pragma once

#include <QWidget>

class QLabel;
class QMenu;
class QToolButton;
class QTreeWidget;

namespace keyblock {

class Commands;
class Comparison;
class Runs;
class Themes;

class RunList : public QWidget {
    Q_OBJECT

public:
    RunList(const Themes& themes, const Commands& commands, Runs& runs, Comparison& comparison, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {415, 214}; }

private:
    void fill();
    void showMenu(const QPoint& at);
    void fillCompareMenu(QMenu& menu);

    const Themes& themes_;
    const Commands& commands_;
    Runs& runs_;
    Comparison& comparison_;
    QLabel* stale_;
    QToolButton* compare_;
    QTreeWidget* list_;
};

}  // namespace keyblock
