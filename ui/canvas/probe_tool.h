// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The probe: while it is switched on, the values under the mouse are shown next to it,
// and a click pins them. Pins are small numbered flags above the section that are shown
// whether or not the probe is on; each moves with its point.
#pragma once

#include "ui/canvas/canvas_tool.h"
#include "ui/picture/charts/pins.h"
#include "ui/picture/section/probe.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace keyblock {

class Canvas;
class Themes;

class Probe : public QObject, public CanvasTool {
    Q_OBJECT

public:
    /// Returns the values of a picked object; null if the section shows no results.
    using Reading = std::function<std::optional<ProbeReading>(const Pick&)>;

    Probe(Canvas& canvas, const Themes& themes, Reading reading, QObject* parent = nullptr);
    ~Probe() override;

    void setOn(bool on);
    bool isOn() const { return on_; }
    void setPins(std::vector<Pin> pins);

    void press(const CanvasEvent& event) override;
    void move(const CanvasEvent& event) override;
    void leave() override;
    void paintAbovePanels(QPainter& painter, const CanvasMap& map) const override;
    QCursor cursor() const override { return Qt::CrossCursor; }

Q_SIGNALS:
    void switched(bool on);
    void pinned(const keyblock::Pick& pick, const keyblock::Point& place);
    void unpinAsked(int number);
    void unpinAllAsked();
    void keepAsked(int number);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Paints the flags, below the active tool.
    class Flags : public CanvasOverlay {
    public:
        explicit Flags(const Probe& probe) : probe_(probe) {}
        void paint(QPainter& painter, const CanvasMap& map) const override;

    private:
        const Probe& probe_;
    };

    const Pin* pinUnder(const QPointF& pixel) const;
    void showMenu(const Pin& pin, const QPoint& global);

    Canvas& canvas_;
    const Themes& themes_;
    Reading reading_;
    CanvasTool* before_ = nullptr;  // the tool that becomes active again when the probe is switched off
    bool on_ = false;
    std::optional<QPointF> mouse_;  // position of the mouse; null: not over the canvas
    std::vector<Pin> pins_;
    Flags flags_;
};

}  // namespace keyblock
