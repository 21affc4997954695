// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/file_watch.h"

#include "ui/document/document.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QTimer>

namespace keyblock {

namespace {

/// Hash of the file; empty if it cannot be read.
QByteArray hashOf(const QString& path) {
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha1);
    return file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result() : QByteArray();
}

}  // namespace

FileWatch::FileWatch(Document& document, QObject* parent)
    : QObject(parent), document_(document), watcher_(new QFileSystemWatcher(this)), settled_(new QTimer(this)) {
    settled_->setSingleShot(true);
    settled_->setInterval(300);
    connect(settled_, &QTimer::timeout, this, &FileWatch::look);
    for (const auto signal : {&QFileSystemWatcher::fileChanged, &QFileSystemWatcher::directoryChanged})
        connect(watcher_, signal, this, [this] { settled_->start(); });
    connect(&document, &Document::replaced, this, &FileWatch::follow);
    connect(&document, &Document::fileChanged, this, [this] {
        if (!document_.isModified()) follow();  // saved
    });
}

/// Qt stops watching a file that is replaced, so its folder is watched too.
void FileWatch::follow() {
    const QStringList watched = watcher_->files() + watcher_->directories();
    if (!watched.isEmpty()) watcher_->removePaths(watched);
    path_ = document_.path();
    known_ = path_.isEmpty() ? QByteArray() : hashOf(path_);
    if (!path_.isEmpty()) watcher_->addPaths({path_, QFileInfo(path_).path()});
}

void FileWatch::look() {
    if (path_.isEmpty() || path_ != document_.path()) return;
    if (!watcher_->files().contains(path_)) watcher_->addPath(path_);
    if (!QFileInfo::exists(path_) && !known_.isEmpty()) {
        known_.clear();
        document_.fileIsGone();
        Q_EMIT goneFromDisk(path_);
    }
    const QByteArray now = hashOf(path_);
    if (now.isEmpty() || now == known_) return;
    known_ = now;
    Q_EMIT changedOnDisk(path_);
}

}  // namespace keyblock
