// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows the scene as drawn on the canvas, while the drawing is shown.
#pragma once

#include <QObject>

namespace keyblock {

class Canvas;
class Document;
class Visibility;

class DrawingFeed : public QObject {
    Q_OBJECT

public:
    DrawingFeed(Document& document, const Visibility& visibility, Canvas& canvas, QObject* parent = nullptr);

    bool isOn() const { return on_; }
    /// On: the canvas shows the drawing and is updated with it. Off: others use the canvas.
    void setOn(bool on);

Q_SIGNALS:
    void switched(bool on);

private:
    void show();
    void showHint();

    Document& document_;
    const Visibility& visibility_;
    Canvas& canvas_;
    bool on_ = true;
    bool isOther_ = false;  // another document, not shown yet
};

}  // namespace keyblock
