// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scenes that were opened or saved last, stored in the user's settings.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>

#include <vector>

namespace keyblock {

class Document;

struct RecentFile {
    QString path;
    QDateTime opened;
};

class RecentFiles : public QObject {
    Q_OBJECT

public:
    /// Follows the document: the file that was opened or saved last comes first.
    explicit RecentFiles(Document& document, QObject* parent = nullptr);

    /// The recent files, latest first. Missing files are included, so that the user sees that they no longer exist.
    const std::vector<RecentFile>& files() const { return files_; }
    void add(const QString& path);
    void forget(const QString& path);

Q_SIGNALS:
    void changed();

private:
    void keep() const;

    std::vector<RecentFile> files_;
};

}  // namespace keyblock
