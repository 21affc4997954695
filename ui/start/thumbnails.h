// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of scene files, painted on their own thread because the scene has to be cut
// first, and kept in the user's cache folder until the file changes.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace keyblock {

struct Theme;

/// What a card shows of a scene.
struct SceneFacts {
    int blocks = 0, bolts = 0;
    int errors = 0, warnings = 0;
    bool isThere = false;  // the file is a scene that could be read, at least in part
};

class Thumbnails : public QObject {
    Q_OBJECT

public:
    explicit Thumbnails(QObject* parent = nullptr);
    ~Thumbnails() override;

    /// Requests the picture of a scene file, in pixels of the screen; `ready` delivers it, from the cache or later.
    void ask(const QString& path, QSize size, double ratio, const Theme& theme);

Q_SIGNALS:
    void ready(const QString& path, QSize size, const QImage& image, keyblock::SceneFacts facts);

private:
    struct Wanted {
        QString path;
        QSize size;
        double ratio;
        const Theme* theme;
    };
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Wanted> wanted_;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace keyblock
