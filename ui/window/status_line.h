// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The status line: cursor position, object under the cursor, model size, next undo
// step, units and sign convention.
#pragma once

#include <QObject>

class QLabel;
class QStatusBar;

namespace keyblock {

class Canvas;
class Display;
class Document;

class StatusLine : public QObject {
    Q_OBJECT

public:
    StatusLine(QStatusBar& bar, Document& document, Canvas& canvas, Display& display);

private:
    void showCounts();
    void showUndo();

    Document& document_;
    Canvas& canvas_;
    Display& display_;
    QLabel *place_, *under_, *counts_, *undo_, *units_;
};

}  // namespace keyblock
