// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recent_files.h"

#include "ui/document/document.h"

#include <QSettings>

namespace keyblock {

namespace {

constexpr std::size_t mostFiles = 12;
constexpr char pathsKey[] = "recent/paths", timesKey[] = "recent/times";

}  // namespace

RecentFiles::RecentFiles(Document& document, QObject* parent) : QObject(parent) {
    const QSettings settings;
    const QStringList paths = settings.value(pathsKey).toStringList(), times = settings.value(timesKey).toStringList();
    for (int i = 0; i < paths.size() && i < int(mostFiles); ++i)
        files_.push_back({paths[i], QDateTime::fromString(times.value(i), Qt::ISODate)});
    connect(&document, &Document::fileChanged, this, [this, &document, last = QString()]() mutable {
        if (document.path() != last && !document.path().isEmpty()) add(document.path());
        last = document.path();
    });
}

void RecentFiles::add(const QString& path) {
    std::erase_if(files_, [&](const RecentFile& file) { return file.path == path; });
    files_.insert(files_.begin(), {path, QDateTime::currentDateTime()});
    if (files_.size() > mostFiles) files_.resize(mostFiles);
    keep();
    Q_EMIT changed();
}

void RecentFiles::forget(const QString& path) {
    if (std::erase_if(files_, [&](const RecentFile& file) { return file.path == path; }) == 0) return;
    keep();
    Q_EMIT changed();
}

void RecentFiles::keep() const {
    QStringList paths, times;
    for (const RecentFile& file : files_) {
        paths << file.path;
        times << file.opened.toString(Qt::ISODate);
    }
    QSettings settings;
    settings.setValue(pathsKey, paths);
    settings.setValue(timesKey, times);
}

}  // namespace keyblock
