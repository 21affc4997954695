// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/file_folder.h"

#include "ui/document/document.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace keyblock {

namespace {

constexpr char folderKey[] = "files/folder";

}  // namespace

QString fileFolder(const Document& document) {
    if (!document.path().isEmpty()) return QFileInfo(document.path()).absolutePath();
    const QString last = QSettings().value(folderKey).toString();
    if (!last.isEmpty() && QDir(last).exists()) return last;
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents).exists() ? documents : QDir::homePath();
}

void rememberFolderOf(const QString& path) { QSettings().setValue(folderKey, QFileInfo(path).absolutePath()); }

}  // namespace keyblock
