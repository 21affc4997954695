// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows the scene as it is drawn on the canvas, while that is what is looked at.
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
    /// On: the canvas shows the drawing, and follows it. Off: others show on the canvas what they have.
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
    bool isOther_ = false;  // another document, of which nothing was shown yet
};

}  // namespace keyblock
