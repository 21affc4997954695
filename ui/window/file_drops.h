// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files dropped on the window are opened as if the user had chosen them.
#pragma once

#include <QObject>

#include <functional>

class QMainWindow;
class QMimeData;

namespace keyblock {

class FileDrops : public QObject {
    Q_OBJECT

public:
    /// `open` gets the first file with a known extension: .json, .kbrun, .dxf or .csv.
    FileDrops(QMainWindow& window, std::function<void(const QString& path)> open);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<void(const QString&)> open_;
};

/// The first of these files that Studio can open; empty: none.
QString openableFile(const QMimeData& dropped);

}  // namespace keyblock
