// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_desk.h"

#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/theme.h"
#include "ui/tools/clipboard.h"
#include "ui/tools/coordinate_box.h"
#include "ui/tools/scene_overlay.h"
#include "ui/tools/select_tool.h"
#include "ui/tools/tool.h"
#include "ui/tools/tool_bar.h"
#include "ui/tools/tool_painter.h"
#include "ui/tools/tool_palette.h"
#include "ui/tools/tools.h"

#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QTimer>

#include <algorithm>

namespace keyblock {
namespace {

constexpr int messageTime = 8000;  // [ms]

}  // namespace

ToolDesk::ToolDesk(Canvas& canvas, Document& document, Selection& selection, const Visibility& visibility,
                   const Display& display, const Themes& themes, Commands& commands, QObject* parent)
    : QObject(parent),
      bench_(std::make_unique<Workbench>(canvas, document, selection, visibility, display, themes)),
      tools_(makeAllTools(*bench_)), overlay_(std::make_unique<SceneOverlay>(*bench_)),
      palette_(new ToolPalette(themes)), bar_(new ToolBar(display, themes)), box_(new CoordinateBox(canvas, themes)),
      forget_(new QTimer(this)) {
    forget_->setSingleShot(true);
    connect(forget_, &QTimer::timeout, this, [this] { tell({}, false); });
    for (const auto& tool : tools_) {
        connect(tool.get(), &Tool::changed, this, &ToolDesk::showTool);
        connect(tool.get(), &Tool::finished, this, &ToolDesk::choose);
    }
    addToolCommands(commands, *this, *palette_, actions_);
    addModeCommands(commands, *bench_);
    new Clipboard(*bench_, static_cast<SelectTool&>(*tools_.front()), commands, this);
    connect(bench_.get(), &Workbench::said, this, &ToolDesk::tell);
    connect(box_, &CoordinateBox::placed, this, &ToolDesk::take);
    connect(bar_, &ToolBar::cancelled, this, &ToolDesk::stepBack);
    connect(bar_, &ToolBar::committed, this, &ToolDesk::enter);
    connect(bar_, &ToolBar::leftField, &canvas, qOverload<>(&QWidget::setFocus));
    connect(&document, &Document::changed, this, [this, &document] {
        if (!document.isPreviewing()) tool_->refresh();
        showTool();
    });
    connect(&document, &Document::replaced, this, [this] {
        choose("select");
        showRoomToDraw();
    });
    connect(&document, &Document::checkedChanged, this, &ToolDesk::showSelected);
    connect(&selection, &Selection::changed, this, &ToolDesk::showSelected);
    // Zooming with the wheel moves the section under the mouse, even if the mouse does not move.
    connect(&canvas, &Canvas::viewChanged, this, [this, &canvas] {
        if (at_) move({canvas.map().toPlace(at_->pixel), at_->pixel, Qt::NoButton, Qt::NoButton, at_->modifiers});
    });
    canvas.installEventFilter(this);
    canvas.addOverlay(overlay_.get());
    choose("select");
    canvas.setTool(this);
}

ToolDesk::~ToolDesk() {
    bench_->canvas().setTool(nullptr);
    bench_->canvas().removeOverlay(overlay_.get());
}

void ToolDesk::choose(const QString& id) {
    const auto found = std::find_if(tools_.begin(), tools_.end(), [&](const auto& tool) { return tool->id() == id; });
    if (found == tools_.end()) return;
    if (tool_) tool_->end();
    box_->stop();
    tool_ = found->get();
    tool_->begin();
    if (id != "select" && tool_->changes()) bench_->selection().clear();  // it would show through the preview
    for (QAction* action : actions_) action->setChecked(action->objectName() == "tool." + id);
    showTool();
    bench_->canvas().setFocus();
    Q_EMIT chosen(id);
    if (!bench_->isDrawing() && tool_->changes() && id != "select") Q_EMIT drawingAsked();
}

void ToolDesk::setDrawing(bool drawing) {
    bench_->setDrawing(drawing);
    bar_->setVisible(drawing);
    if (!drawing && tool_->changes()) choose("select");
    showSelected();
}

void ToolDesk::showTool() {
    bar_->show(tool_);
    if (!tool_->wantsPlaces()) box_->stop();
    bench_->canvas().refresh();
}

void ToolDesk::showSelected() {
    overlay_->forget();
    if (bench_->isDrawing()) bench_->canvas().setSelectedBolts(selectedBolts(*bench_));
    bench_->canvas().refresh();
}

void ToolDesk::showRoomToDraw() {
    if (bench_->objects().empty()) bench_->canvas().zoomTo({{-20.0, -18.0}, {20.0, 18.0}});
}

void ToolDesk::stepBack() {
    if (bench_->canvas().endZoomBox()) return;
    if (tool_->back()) return showTool();
    if (tool_->id() != "select") return choose("select");
    bench_->selection().clear();
}

void ToolDesk::enter() {
    if (tool_->enter()) showTool();
    bench_->canvas().setFocus();
}

void ToolDesk::take(const Point& typed) {
    Pointed at{typed, typed, {}, bench_->canvas().map().toPixel(typed), {}, true};
    tool_->move(at);
    tool_->press(at);
    tool_->release(at);
    showTool();
}

void ToolDesk::tell(const QString& text, bool warns) {
    message_ = text;
    warns_ = warns;
    if (!text.isEmpty()) forget_->start(messageTime);
    Q_EMIT said(text, warns);
    bench_->canvas().refresh();
}

Pointed ToolDesk::pointed(const CanvasEvent& event) const {
    if (!tool_->snaps()) return {event.place, event.place, {}, event.pixel, event.modifiers};
    return bench_->pointAt(event.place, event.pixel, event.modifiers, tool_->previous(), tool_->unsnapped(),
                           [this](const Snap& snap) { return tool_->accepts(snap); });
}

void ToolDesk::follow(const Pointed& at) {
    at_ = at;
    if (tool_->wantsPlaces())
        box_->follow(at.place, at.pixel, tool_->previous(), at.snap && at.snap->kind != SnapKind::Grid);
    bench_->canvas().refresh();
}

void ToolDesk::press(const CanvasEvent& event) {
    bench_->canvas().setFocus();
    if (event.button != Qt::LeftButton) return;
    const Pointed at = pointed(event);
    tell({}, false);
    tool_->press(at);
    follow(at);
    showTool();
}

void ToolDesk::doubleClick(const CanvasEvent& event) {
    if (event.button != Qt::LeftButton) return;
    tool_->doubleClick(pointed(event));
    showTool();
}

void ToolDesk::move(const CanvasEvent& event) {
    const Pointed at = pointed(event);
    tool_->move(at);
    follow(at);
}

void ToolDesk::release(const CanvasEvent& event) {
    if (event.button != Qt::LeftButton) return;
    const Pointed at = pointed(event);
    tool_->release(at);
    follow(at);
}

void ToolDesk::leave() {
    at_.reset();
    tool_->leave();
    if (!box_->isTyping()) box_->hide();
    bench_->canvas().refresh();
}

void ToolDesk::contextMenu(const CanvasEvent& event, QPoint global) {
    const Pointed at = pointed(event);
    auto* menu = new QMenu(&bench_->canvas());
    menu->setAttribute(Qt::WA_DeleteOnClose);
    tool_->fillMenu(*menu, at);
    if (tool_->wantsPlaces()) {
        QAction* finish = menu->addAction(tr("Enter"), this, &ToolDesk::enter);
        finish->setEnabled(!tool_->commitText().isEmpty());
        QAction* undo = menu->addAction(tr("Undo last point"), this, [this] { tool_->undoPoint(), showTool(); });
        undo->setEnabled(tool_->previous().has_value());
        QAction* close = menu->addAction(tr("Close"), this, [this] { tool_->close(), showTool(); });
        close->setEnabled(tool_->previous().has_value());
        menu->addSeparator();
        menu->addAction(tr("Cancel"), this, &ToolDesk::stepBack);
    }
    menu->isEmpty() ? menu->deleteLater() : menu->popup(global);
}

QCursor ToolDesk::cursor() const { return tool_->cursor(); }
bool ToolDesk::isDrawing() const { return tool_->previous().has_value(); }

void ToolDesk::paint(QPainter& painter, const CanvasMap& map) const {
    ToolPainter ink(painter, map, bench_->theme());
    painter.save();
    if (bench_->modes().gridShown) ink.grid(bench_->gridSpacing());
    tool_->paint(painter, map);
    if (at_ && tool_->snaps() && at_->snap && !at_->typed) ink.snap(*at_->snap);
    const bool shows = tool_->wantsPlaces() || !message_.isEmpty();
    const QString text = tool_->wantsPlaces() ? tr("%1: %2").arg(tool_->title(), tool_->prompt()) : tool_->title();
    const QString detail = message_.isEmpty() ? tool_->detail() : message_;
    if (shows) ToolPainter::prompt(painter, bench_->theme(), text, detail, warns_ && !message_.isEmpty(), map.size().width());
    painter.restore();
}

bool ToolDesk::wants(QKeyEvent& event) const {
    const bool plain = (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0;
    const QString text = event.text();
    switch (event.key()) {
        case Qt::Key_Escape:
        case Qt::Key_Return:
        case Qt::Key_Enter: return true;
        case Qt::Key_Tab:
        case Qt::Key_Backtab: return tool_->wantsPlaces();
        case Qt::Key_Backspace: return plain;
        case Qt::Key_Z: return event.modifiers() == Qt::ControlModifier && tool_->previous().has_value();
        default: break;
    }
    const bool typed = text.size() == 1 && QString("0123456789@=-+.").contains(text);
    return plain && typed && tool_->wantsPlaces();
}

bool ToolDesk::handle(QKeyEvent& event) {
    if (!wants(event)) return tool_->key(event) || (event.key() == Qt::Key_C && !event.modifiers() && tool_->close());
    switch (event.key()) {
        case Qt::Key_Escape: stepBack(); return true;
        case Qt::Key_Return:
        case Qt::Key_Enter: enter(); return true;
        case Qt::Key_Z:
        case Qt::Key_Backspace: tool_->undoPoint(); return true;
        case Qt::Key_Tab:
        case Qt::Key_Backtab: box_->begin({}, tool_->previous()); return true;
        default: box_->begin(event.text(), tool_->previous()); return true;
    }
}

bool ToolDesk::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && wants(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress && handle(static_cast<QKeyEvent&>(*event))) {
        showTool();
        event->accept();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace keyblock
