// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes that were opened or saved last, kept in the person's settings.
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
    /// Follows the document: what it opens or saves comes first.
    explicit RecentFiles(Document& document, QObject* parent = nullptr);

    /// Newest first; files that are gone too, so that a person sees what became of them.
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
