// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that are dropped on the window are opened as if they had been chosen.
#pragma once

#include <QObject>

#include <functional>

class QMainWindow;
class QMimeData;

namespace keyblock {

class FileDrops : public QObject {
    Q_OBJECT

public:
    /// `open` gets the first file that Studio knows: .json, .kbrun, .dxf or .csv.
    FileDrops(QMainWindow& window, std::function<void(const QString& path)> open);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<void(const QString&)> open_;
};

/// The first file of these that Studio opens; empty: none.
QString openableFile(const QMimeData& dropped);

}  // namespace keyblock
