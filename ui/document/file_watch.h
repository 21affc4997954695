// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Notices when another program writes the document's file, or takes it away.
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
    void changedOnDisk(const QString& path);  // the file says something else than what was opened or saved
    void goneFromDisk(const QString& path);

private:
    void follow();
    void look();

    Document& document_;
    QFileSystemWatcher* watcher_;
    QTimer* settled_;  // whoever writes a file may need several goes
    QString path_;
    QByteArray known_;  // hash of what the file said
};

}  // namespace keyblock
