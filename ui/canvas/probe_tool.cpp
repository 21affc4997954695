// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/probe_tool.h"

#include "ui/canvas/call_out.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/pin_flag.h"
#include "ui/canvas/probe_panel.h"
#include "ui/look/theme.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>

#include <algorithm>
#include <utility>

namespace keyblock {

Probe::Probe(Canvas& canvas, const Themes& themes, Reading reading, QObject* parent)
    : QObject(parent), canvas_(canvas), themes_(themes), reading_(std::move(reading)), flags_(*this) {
    canvas.addOverlay(&flags_);
    canvas.installEventFilter(this);
}

Probe::~Probe() {
    setOn(false);
    canvas_.removeOverlay(&flags_);
}

void Probe::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    mouse_.reset();
    if (on) before_ = canvas_.tool();
    canvas_.setTool(on ? this : std::exchange(before_, nullptr));
    if (on) {
        canvas_.installEventFilter(this);  // for Esc: the filter that was installed last is called first
        canvas_.setFocus();
    }
    Q_EMIT switched(on);
}

void Probe::setPins(std::vector<Pin> pins) {
    pins_ = std::move(pins);
    canvas_.refresh();
}

void Probe::press(const CanvasEvent& event) {
    canvas_.setFocus();
    if (event.button != Qt::LeftButton) return;
    const std::optional<Pick> pick = canvas_.pickAt(event.pixel);
    if (pick && reading_(*pick)) Q_EMIT pinned(*pick, event.place);
}

void Probe::move(const CanvasEvent& event) {
    mouse_ = event.pixel;
    canvas_.refresh();
}

void Probe::leave() {
    mouse_.reset();
    canvas_.refresh();
}

void Probe::paintAbovePanels(QPainter& painter, const CanvasMap& map) const {
    if (!mouse_) return;
    const std::optional<Pick> pick = canvas_.pickAt(*mouse_);
    const std::optional<ProbeReading> reading = pick ? reading_(*pick) : std::nullopt;
    if (reading) paintProbePanel(painter, themes_.current(), *reading, *mouse_, map.size());
}

void Probe::Flags::paint(QPainter& painter, const CanvasMap& map) const {
    if (!probe_.canvas_.picture()) return;
    for (const Pin& pin : probe_.pins_)
        if (const auto place = placeOf(pin, *probe_.canvas_.picture()))
            paintPinFlag(painter, probe_.themes_.current(), map.toPixel(*place), pin.number);
}

const Pin* Probe::pinUnder(const QPointF& pixel) const {
    if (!canvas_.picture()) return nullptr;
    for (auto pin = pins_.rbegin(); pin != pins_.rend(); ++pin)
        if (const auto place = placeOf(*pin, *canvas_.picture()))
            if (pinFlagRect(canvas_.map().toPixel(*place), pin->number).contains(pixel)) return &*pin;
    return nullptr;
}

void Probe::showMenu(const Pin& pin, const QPoint& global) {
    auto* menu = new QMenu(&canvas_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const int number = pin.number;
    menu->addAction(tr("Unpin %1").arg(number), this, [this, number] { Q_EMIT unpinAsked(number); });
    menu->addAction(tr("Save as monitor"), this, [this, number] { Q_EMIT keepAsked(number); });
    if (pins_.size() > 1) menu->addAction(tr("Unpin all"), this, &Probe::unpinAllAsked);
    menu->popup(global);
}

/// Esc ends the probe. The menus of flags are available with any tool.
bool Probe::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (on_ && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        if (event->type() == QEvent::KeyPress) setOn(false);
        return true;
    }
    if (event->type() != QEvent::ContextMenu) return QObject::eventFilter(watched, event);
    const auto& asked = static_cast<QContextMenuEvent&>(*event);
    const Pin* pin = pinUnder(asked.pos());
    if (!pin) return QObject::eventFilter(watched, event);
    showMenu(*pin, asked.globalPos());
    return true;
}

}  // namespace keyblock
