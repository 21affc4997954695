// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/select_tool.h"

#include "geometry/segment.h"
#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/edit/hit.h"
#include "ui/look/plain_text.h"
#include "ui/tools/tool_painter.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMenu>
#include <QRectF>

#include <algorithm>

namespace keyblock {
namespace {

constexpr double hitReach = 7.0, handleReach = 8.0, dragStart = 4.0, wallReach = 24.0;  // [px]
constexpr std::size_t mostNear = 100;  // objects with more lines are not highlighted as a whole

}  // namespace

std::vector<std::string> SelectTool::selected() const {
    std::vector<std::string> pointers;
    for (const QString& pointer : bench().selection().pointers()) pointers.push_back(pointer.toStdString());
    return pointers;
}

std::vector<Handle> SelectTool::handles() const {
    if (bench().selection().pointers().size() != 1) return {};
    return handlesOf(*bench().document().scene(), bench().selection().pointers().first().toStdString());
}

std::optional<std::size_t> SelectTool::handleAt(const QPointF& pixel) const {
    const std::vector<Handle> all = handles();
    double nearest = handleReach;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double distance = QLineF(bench().canvas().map().toPixel(all[i].place), pixel).length();
        if (distance < nearest) nearest = distance, found = i;
    }
    return found;
}

QString SelectTool::objectAt(const Point& place) const {
    std::vector<std::size_t> found = objectsAt(bench().objects(), place, bench().metres(hitReach));
    std::erase_if(found, [&](std::size_t index) { return bench().isLocked(bench().objects()[index].pointer); });
    if (found.empty()) return {};
    // A selected object takes precedence, so that it can be dragged across others.
    for (const std::size_t index : found) {
        const QString pointer = QString::fromStdString(bench().objects()[index].pointer);
        if (bench().selection().contains(pointer) && bench().objects()[index].area.empty()) return pointer;
    }
    return QString::fromStdString(bench().objects()[found.front()].pointer);
}

void SelectTool::press(const Pointed& at) {
    if (!bench().isDrawing()) return;  // results are selected by the window
    pressed_ = at;
    single_ = false;
    hot_ = handleAt(at.pixel);
    if (hot_) {
        doing_ = Doing::Presses;
        return;
    }
    const QString pointer = objectAt(at.raw);
    const bool plain = !(at.modifiers & (Qt::ControlModifier | Qt::ShiftModifier));
    if (pointer.isEmpty()) {
        doing_ = Doing::Boxes;
        boxEnd_ = at.pixel;
        return;
    }
    doing_ = Doing::Presses;
    single_ = plain && bench().selection().contains(pointer) && bench().selection().pointers().size() > 1;
    if (!single_) choose(pointer, at.modifiers);
    hover_ = pointer;
}

void SelectTool::choose(const QString& pointer, Qt::KeyboardModifiers modifiers) {
    Selection& selection = bench().selection();
    if (modifiers & Qt::ShiftModifier)
        selection.remove(pointer);
    else if (modifiers & Qt::ControlModifier)
        selection.add(pointer);
    else if (!selection.contains(pointer) || selection.pointers().size() > 1)
        selection.set({pointer});
}

void SelectTool::move(const Pointed& at) {
    if (doing_ == Doing::Presses && QLineF(at.pixel, pressed_.pixel).length() > dragStart) beginDrag();
    if (doing_ == Doing::Moves || doing_ == Doing::Shapes) return drag(at);
    if (doing_ == Doing::Boxes) {
        boxEnd_ = at.pixel;
        return;
    }
    if (doing_ != Doing::Nothing || !bench().isDrawing()) return;
    mouse_ = at.raw;
    hot_ = handleAt(at.pixel);
    hover_ = hot_ ? QString() : objectAt(at.raw);
}

void SelectTool::beginDrag() {
    const std::vector<Handle> all = handles();
    const bool gone = hot_ ? *hot_ >= all.size() : bench().selection().isEmpty();  // deleted with a key since the press
    doing_ = gone ? Doing::Nothing : hot_ ? Doing::Shapes : Doing::Moves;
    if (gone) return;
    if (hot_) {
        shaped_ = selected().front();
        grab_ = all[*hot_].place;
        return;
    }
    // The point at which the object was grabbed is moved to the snap point.
    const Pointed held = bench().pointAt(pressed_.raw, pressed_.pixel, {}, std::nullopt, {});
    grab_ = held.snap && held.snap->kind != SnapKind::Grid ? held.place : pressed_.raw;
}

Edit SelectTool::dragged(const Point& place) const {
    if (doing_ == Doing::Shapes && hot_)
        return dragHandle(scene(), shaped_, *hot_, place, bench().metres(wallReach));
    return moveAll(scene(), selected(), place - grab_);
}

void SelectTool::drag(const Pointed& at) {
    const Edit edit = dragged(at.place);
    if (edit.done())
        bench().document().preview(edit.scene);
    else
        bench().say(QString::fromStdString(edit.refusal), true);
}

QString SelectTool::titleOf(const std::vector<std::string>& pointers) const {
    return pointers.size() == 1 ? QString::fromStdString(titleAt(scene(), pointers.front()))
                                : tr("%n objects", nullptr, static_cast<int>(pointers.size()));
}

QString SelectTool::stepName() const {
    return doing_ == Doing::Shapes ? tr("Change %1").arg(titleOf({shaped_})) : tr("Move %1").arg(titleOf(selected()));
}

void SelectTool::release(const Pointed& at) {
    if (!bench().isDrawing()) return;
    const Doing did = doing_;
    if (did == Doing::Moves || did == Doing::Shapes) {
        const QString step = stepName();
        const Edit edit = dragged(at.place);
        doing_ = Doing::Nothing;
        bench().document().endPreview();
        bench().commit(step, edit);
    }
    doing_ = Doing::Nothing;
    if (did == Doing::Boxes) chooseBox(at);
    if (did == Doing::Presses && single_) bench().selection().set({hover_});
    move(at);
}

void SelectTool::chooseBox(const Pointed& at) {
    const bool adds = at.modifiers & Qt::ControlModifier, removes = at.modifiers & Qt::ShiftModifier;
    QStringList chosen = adds || removes ? bench().selection().pointers() : QStringList();
    if (QLineF(at.pixel, pressed_.pixel).length() > dragStart) {
        const Box box{pressed_.raw.cwiseMin(at.raw), pressed_.raw.cwiseMax(at.raw)};
        const BoxRule rule = at.pixel.x() < pressed_.pixel.x() ? BoxRule::Crosses : BoxRule::Encloses;
        for (const std::size_t index : objectsIn(bench().objects(), box, rule)) {
            const QString pointer = QString::fromStdString(bench().objects()[index].pointer);
            if (bench().isLocked(pointer.toStdString())) continue;
            removes ? void(chosen.removeAll(pointer)) : chosen.append(pointer);
        }
    }
    bench().selection().set(chosen);
}

void SelectTool::doubleClick(const Pointed& at) {
    if (!bench().isDrawing() || bench().selection().pointers().size() != 1 || handleAt(at.pixel)) return;
    const std::string pointer = selected().front();
    if (objectAt(at.raw).toStdString() != pointer) return;
    const Edit edit = withCorner(scene(), pointer, at.raw);
    if (edit.done()) bench().commit(tr("Insert corner in %1").arg(QString::fromStdString(titleAt(scene(), pointer))), edit);
}

void SelectTool::leave() {
    if (doing_ == Doing::Nothing) hover_.clear(), hot_.reset();
}

bool SelectTool::back() {
    if (doing_ == Doing::Nothing) return false;
    doing_ = Doing::Nothing;
    bench().document().endPreview();
    return true;
}

void SelectTool::end() {
    back();
    hover_.clear();
    hot_.reset();
}

void SelectTool::removeSelected() {
    if (!bench().isDrawing()) return;
    const std::vector<Handle> all = handles();
    const bool corner = hot_ && *hot_ < all.size() && all[*hot_].isCorner;
    if (!corner && selected().empty()) return;
    const std::vector<std::string> gone = corner ? std::vector{all[*hot_].pointer} : selected();
    const QString what = titleOf(gone);
    back();
    hot_.reset();
    hover_.clear();
    bench().commit((corner ? tr("Delete corner of %1") : tr("Delete %1")).arg(what), removeAll(scene(), gone));
}

void SelectTool::nudge(const Point& way) {
    if (bench().selection().isEmpty() || doing_ != Doing::Nothing || !bench().isDrawing()) return;
    const double grid = bench().gridSpacing();
    const double step = bench().modes().gridSnap ? grid : 0.1 * grid;
    bench().commit(stepName(), moveAll(scene(), selected(), step * way));
}

bool SelectTool::key(QKeyEvent& event) {
    const double times = event.modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
    switch (event.key()) {
        case Qt::Key_Left: nudge({-times, 0.0}); return true;
        case Qt::Key_Right: nudge({times, 0.0}); return true;
        case Qt::Key_Up: nudge({0.0, times}); return true;
        case Qt::Key_Down: nudge({0.0, -times}); return true;
        default: return false;
    }
}

void SelectTool::fillMenu(QMenu& menu, const Pointed& at) {
    if (!bench().isDrawing()) return;
    const QString pointer = objectAt(at.raw);
    if (!pointer.isEmpty() && !bench().selection().contains(pointer)) bench().selection().set({pointer});
    if (bench().selection().isEmpty()) return;
    const std::vector<std::string> pointers = selected();
    hot_ = handleAt(at.pixel);
    const Point raw = at.raw;
    if (pointers.size() == 1 && !hot_ && withCorner(scene(), pointers.front(), raw).done())
        menu.addAction(tr("Insert corner"), this, [this, raw, pointer = pointers.front()] {
            bench().commit(tr("Insert corner"), withCorner(scene(), pointer, raw));
        });
    const std::vector<Handle> all = handles();
    if (hot_ && all[*hot_].isCorner)
        menu.addAction(tr("Delete corner"), this, [this, corner = all[*hot_].pointer] {
            bench().commit(tr("Delete corner"), removeAt(scene(), corner));
        });
    menu.addAction(tr("Delete %1").arg(asMenuText(titleOf(pointers))), this, [this] {
        hot_.reset();
        removeSelected();
    });
}

std::optional<Point> SelectTool::previous() const { return snaps() ? std::optional(grab_) : std::nullopt; }

std::vector<std::string> SelectTool::unsnapped() const { return snaps() ? selected() : std::vector<std::string>(); }

void SelectTool::paint(QPainter& painter, const CanvasMap& map) const {
    if (!bench().isDrawing()) return;
    ToolPainter ink(painter, map, bench().theme());
    const SceneObject* over = hover_.isEmpty() || doing_ != Doing::Nothing ? nullptr : bench().object(hover_);
    if (over && !bench().selection().contains(hover_)) {
        // Of a joint set with thousands of traces, only the traces under the mouse are highlighted.
        const bool all = over->lines.size() <= mostNear;
        for (const ObjectLine& line : over->lines)
            if (all || distanceToSegment(line.points.front(), line.points.back(), mouse_) < bench().metres(hitReach))
                ink.near(line.points, line.closed);
        for (const Point& mark : over->marks) ink.handle(mark, true);
    }
    const std::vector<Handle> all = handles();
    for (std::size_t i = 0; i < all.size(); ++i) ink.handle(all[i].place, hot_ == i);
    if (doing_ == Doing::Boxes && QLineF(boxEnd_, pressed_.pixel).length() > dragStart)
        ink.box(QRectF(pressed_.pixel, boxEnd_).normalized(), boxEnd_.x() < pressed_.pixel.x());
}

QCursor SelectTool::cursor() const {
    if (doing_ == Doing::Moves || doing_ == Doing::Shapes || hot_) return Qt::SizeAllCursor;
    return Qt::ArrowCursor;
}

}  // namespace keyblock
