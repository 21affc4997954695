// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_drops.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMainWindow>
#include <QMimeData>
#include <QTimer>
#include <QUrl>

namespace keyblock {

QString openableFile(const QMimeData& dropped) {
    static const QStringList known{"json", "kbrun", "dxf", "csv"};
    for (const QUrl& url : dropped.urls())
        if (url.isLocalFile() && known.contains(QFileInfo(url.toLocalFile()).suffix().toLower())) return url.toLocalFile();
    return {};
}

FileDrops::FileDrops(QMainWindow& window, std::function<void(const QString&)> open)
    : QObject(&window), open_(std::move(open)) {
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool FileDrops::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::DragMove && event->type() != QEvent::Drop)
        return QObject::eventFilter(watched, event);
    auto* drop = static_cast<QDropEvent*>(event);
    const QString file = openableFile(*drop->mimeData());
    drop->setAccepted(!file.isEmpty());
    if (drop->isAccepted()) drop->setDropAction(Qt::CopyAction);
    // Deferred, because a dialog would block the program from which the file was dragged.
    if (event->type() == QEvent::Drop && !file.isEmpty()) QTimer::singleShot(0, this, [this, file] { open_(file); });
    return true;
}

}  // namespace keyblock
