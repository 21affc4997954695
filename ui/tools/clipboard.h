// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cut, copy, paste, duplicate, delete and select all, on what is selected.
#pragma once

#include <QObject>
#include <QStringList>

#include <memory>

namespace keyblock {

class Commands;
struct Scene;
class SelectTool;
class Workbench;

class Clipboard : public QObject {
    Q_OBJECT

public:
    /// Adds the commands.
    Clipboard(Workbench& bench, SelectTool& select, Commands& commands, QObject* parent);

private:
    void copy();
    void paste();
    void duplicate();
    void put(const Scene& source, const QStringList& pointers, const QString& step, double pixels);

    Workbench& bench_;
    SelectTool& select_;
    std::shared_ptr<const Scene> source_;  // null: nothing was copied
    QStringList pointers_;
    int pasted_ = 0;  // times since the copy: each lies a little further
};

}  // namespace keyblock
