// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small panel in the corner of a canvas with the name of the run it shows when two
// runs are compared, and a close button for the run that can be removed.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace keyblock {

class Canvas;
class Themes;

class CanvasCaption : public QFrame {
    Q_OBJECT

public:
    CanvasCaption(Canvas& canvas, const Themes& themes, bool canClose);

    void setText(const QString& text);

Q_SIGNALS:
    void closed();

private:
    void showTheme();

    const Themes& themes_;
    QLabel* text_;
    QToolButton* close_ = nullptr;
};

}  // namespace keyblock
