// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress of the run and its controls, at the right end of the workflow bar. If there
// is no run, a button that starts one.
#pragma once

#include <QWidget>

#include <functional>

class QToolButton;

namespace keyblock {

class Commands;
class Runs;
class Themes;

class RunStatus : public QWidget {
    Q_OBJECT

public:
    /// \pre the run commands have been added to `commands`.
    RunStatus(const Themes& themes, Commands& commands, Runs& runs, QWidget* parent = nullptr);

private:
    class Progress;

    QToolButton* framedButton(const char* command, std::function<QString()> text);
    QString withKeys(const QString& text, const char* command) const;
    bool isPaused() const;
    void refresh();

    const Themes& themes_;
    Commands& commands_;
    Runs& runs_;
    Progress* progress_;
    QToolButton *start_, *pause_, *step_, *stop_;
};

}  // namespace keyblock
