// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of scene files, painted in the background because the scene has to be cut
// first, and kept in the user's cache folder until the file changes.
#pragma once

#include "ui/document/background.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>

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
    explicit Thumbnails(QObject* parent = nullptr) : QObject(parent) {}

    /// Requests the picture of a scene file, in pixels of the screen; `ready` delivers it, from the cache or later.
    void ask(const QString& path, QSize size, double ratio, const Theme& theme);

Q_SIGNALS:
    void ready(const QString& path, QSize size, const QImage& image, keyblock::SceneFacts facts);

private:
    Background painting_;
};

}  // namespace keyblock
