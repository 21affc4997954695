// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of two runs a canvas shows, on a small panel in its corner; with a cross where
// it can be taken away.
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
