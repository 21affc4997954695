// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The box next to the cursor: it shows the coordinates of the mouse and accepts typed
// coordinates. It does not intercept mouse events.
#pragma once

#include "geometry/point.h"

#include <QFrame>
#include <QPointF>

#include <array>
#include <optional>

class QLabel;
class QLineEdit;

namespace keyblock {

class Themes;

class CoordinateBox : public QFrame {
    Q_OBJECT

public:
    CoordinateBox(QWidget& canvas, const Themes& themes);

    /// Moves the box next to `pixel`. Unless the user is typing, the box then shows the coordinates of `place` [m].
    /// \param previous point to which relative coordinates refer
    /// \param belowTag true: leave room above the box for the tag of a snap point
    void follow(const Point& place, const QPointF& pixel, const std::optional<Point>& previous, bool belowTag);

    /// Starts the input of coordinates by keyboard.
    /// \param text first character typed; empty: nothing has been typed yet
    /// \param previous point to which relative coordinates refer
    void begin(const QString& text, const std::optional<Point>& previous);
    bool isTyping() const { return typing_; }
    void stop();

Q_SIGNALS:
    void placed(const keyblock::Point& place);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showTheme();
    void showPlace();
    void say(const QString& text, bool wrong);
    void nextField();
    void take();
    void moveBeside(const QPointF& pixel, bool belowTag);

    const Themes& themes_;
    QWidget& canvas_;
    std::array<QLineEdit*, 2> edits_{};
    QLabel* hint_;
    Point mouse_{0.0, 0.0};
    std::optional<Point> previous_;
    bool typing_ = false, both_ = false;  // both_: Tab was pressed, so that x and y are typed separately
};

}  // namespace keyblock
