// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thumbnails of scene files. They are painted in the background, because the scene has
// to be cut first, and stay in the user's cache folder until the file changes.
#pragma once

#include "ui/document/background.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>

namespace keyblock {

struct Theme;

/// Facts about a scene, shown on its card or in its row on the start page.
struct SceneFacts {
    int blocks = 0, bolts = 0;
    int errors = 0, warnings = 0;
    bool isThere = false;  // the file is a scene of which at least a part could be read
};

class Thumbnails : public QObject {
    Q_OBJECT

public:
    explicit Thumbnails(QObject* parent = nullptr) : QObject(parent) {}

    /// Requests the thumbnail of a scene file. The signal `ready` delivers the thumbnail later.
    /// \param size size of the thumbnail in device-independent pixels
    /// \param ratio device pixel ratio
    void ask(const QString& path, QSize size, double ratio, const Theme& theme);

Q_SIGNALS:
    void ready(const QString& path, QSize size, const QImage& image, keyblock::SceneFacts facts);

private:
    Background painting_;
};

}  // namespace keyblock
