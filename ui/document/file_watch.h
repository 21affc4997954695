// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Detects that another program has changed or removed the file of the document.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

class QFileSystemWatcher;
class QTimer;

namespace keyblock {

class Document;

class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(Document& document, QObject* parent = nullptr);

Q_SIGNALS:
    void changedOnDisk(const QString& path);  // the file differs from the version opened or saved
    void goneFromDisk(const QString& path);

private:
    void follow();
    void look();

    Document& document_;
    QFileSystemWatcher* watcher_;
    QTimer* settled_;  // delays the check, because a program may write a file in several parts
    QString path_;
    QByteArray known_;  // hash of the file contents
};

}  // namespace keyblock
