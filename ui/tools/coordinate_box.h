// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The box at the cursor: it shows where the mouse is, and takes places as they are
// typed. The mouse goes through it.
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

    /// Shows the place beside `pixel`, unless a person is typing. `previous` is what relative places go by.
    void follow(const Point& place, const QPointF& pixel, const std::optional<Point>& previous, bool belowTag);

    /// Begins to take a place, with the first key typed.
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
    bool typing_ = false, both_ = false;  // both_: Tab said that x and y are meant
};

}  // namespace keyblock
