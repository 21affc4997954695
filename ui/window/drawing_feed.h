// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows the scene on the canvas as it is drawn, unless the canvas shows results.
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
    /// True: the canvas shows the drawing, which is updated whenever the document changes. False: the canvas is left to
    /// other views.
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
    bool isOther_ = false;  // true: the document was replaced and has not been shown yet
};

}  // namespace keyblock
