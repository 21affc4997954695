// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands cut, copy, paste, duplicate, delete and select all, which act on the
// selection.
#pragma once

#include <QList>
#include <QObject>
#include <QStringList>

#include <memory>

class QAction;

namespace keyblock {

class Commands;
struct Scene;
class SelectTool;
class Workbench;

class Clipboard : public QObject {
    Q_OBJECT

public:
    /// Adds the commands Cut, Copy, Paste, Duplicate, Delete and Select all to `commands`.
    Clipboard(Workbench& bench, SelectTool& select, Commands& commands, QObject* parent);

private:
    void cut();
    void copy();
    void paste();
    void duplicate();
    void remove();
    void selectAll();
    void showWhatCan();
    void put(const Scene& source, const QStringList& pointers, const QString& step, double pixels);

    Workbench& bench_;
    SelectTool& select_;
    QList<QAction*> copying_;
    QAction *delete_, *paste_, *all_;
    std::shared_ptr<const Scene> source_;  // scene that the objects were copied from; null: nothing was copied
    QStringList pointers_;
    int pasted_ = 0;  // pastes since the last copy; each paste has a larger offset than the one before
};

}  // namespace keyblock
