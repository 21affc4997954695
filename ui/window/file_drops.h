// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opens files dropped on the window as if the user had chosen them in the Open dialog.
#pragma once

#include <QObject>

#include <functional>

class QMainWindow;
class QMimeData;

namespace keyblock {

class FileDrops : public QObject {
    Q_OBJECT

public:
    /// \param open called with the first dropped file that has a known extension: .json, .kbrun, .dxf or .csv
    FileDrops(QMainWindow& window, std::function<void(const QString& path)> open);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<void(const QString&)> open_;
};

/// Path of the first dropped file that can be opened; empty if there is none.
QString openableFile(const QMimeData& dropped);

}  // namespace keyblock
