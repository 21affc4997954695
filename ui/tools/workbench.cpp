// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/workbench.h"

#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/document/visibility.h"
#include "ui/edit/names.h"
#include "ui/look/theme.h"

#include <QSettings>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double snapReach = 12.0, gridPixels = 24.0;  // [px]

/// The smallest of 1, 2 or 5 times a power of ten that is not below `length`.
double roundSpacing(double length) {
    const double decade = std::pow(10.0, std::floor(std::log10(length)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= length) return factor * decade;
    return 10.0 * decade;
}

/// `place` projected onto the horizontal or vertical line through `previous`, whichever is nearer.
Point straightened(const Point& place, const Point& previous) {
    const Point way = place - previous;
    return std::abs(way.x()) >= std::abs(way.y()) ? Point(place.x(), previous.y()) : Point(previous.x(), place.y());
}

}  // namespace

Workbench::Workbench(Canvas& canvas, Document& document, Selection& selection, const Visibility& visibility,
                     const Display& display, const Themes& themes, QObject* parent)
    : QObject(parent), canvas_(canvas), document_(document), selection_(selection), visibility_(visibility),
      display_(display), themes_(themes) {
    connect(&visibility, &Visibility::changed, this, [this] {
        seen_.reset();
        canvas_.refresh();
    });
    connect(&document, &Document::reported, this, &Workbench::said);
    const QSettings settings;
    modes_.objectSnap = settings.value("draw/objectSnap", true).toBool();
    modes_.ortho = settings.value("draw/ortho", false).toBool();
    modes_.gridSnap = settings.value("draw/gridSnap", false).toBool();
    modes_.gridShown = settings.value("draw/grid", false).toBool();
}

const Theme& Workbench::theme() const { return themes_.current(); }

const Scene& Workbench::scene() const { return *document_.committed(); }

void Workbench::look() const {
    if (seen_ == document_.committed()) return;
    seen_ = document_.committed();
    objects_ = objectsOf(*seen_);
    std::erase_if(objects_, [&](const SceneObject& object) { return isHidden(object.pointer); });
    snaps_ = std::make_unique<SnapIndex>(objects_);
}

const std::vector<SceneObject>& Workbench::objects() const {
    look();
    return objects_;
}

bool Workbench::isHidden(const std::string& pointer) const {
    return visibility_.isHidden(QString::fromStdString(pointer));
}

bool Workbench::isLocked(const std::string& pointer) const {
    return visibility_.isLocked(QString::fromStdString(pointer));
}

const SceneObject* Workbench::object(const QString& pointer) const {
    look();
    const std::string wanted = pointer.toStdString();
    const auto found = std::find_if(objects_.begin(), objects_.end(),
                                    [&](const SceneObject& object) { return object.pointer == wanted; });
    return found == objects_.end() ? nullptr : &*found;
}

void Workbench::setDrawing(bool drawing) {
    drawing_ = drawing;
    Q_EMIT drawingChanged();
}

double Workbench::metres(double pixels) const { return pixels / canvas_.map().pixelsPerMetre(); }

double Workbench::gridSpacing() const { return roundSpacing(metres(gridPixels)); }

void Workbench::setModes(const PointingModes& modes) {
    if (modes == modes_) return;
    modes_ = modes;
    QSettings settings;
    settings.setValue("draw/objectSnap", modes.objectSnap);
    settings.setValue("draw/ortho", modes.ortho);
    settings.setValue("draw/gridSnap", modes.gridSnap);
    settings.setValue("draw/grid", modes.gridShown);
    Q_EMIT modesChanged();
    canvas_.refresh();
}

bool Workbench::isStraight(Qt::KeyboardModifiers modifiers) const {
    return modes_.ortho != modifiers.testFlag(Qt::ShiftModifier);
}

Pointed Workbench::pointAt(const Point& raw, const QPointF& pixel, Qt::KeyboardModifiers modifiers,
                           const std::optional<Point>& previous, const std::vector<std::string>& except) const {
    look();
    Pointed pointed{raw, raw, {}, pixel, modifiers};
    pointed.snap = snaps_->at(raw, {metres(snapReach), modes_.objectSnap, {}, previous, except});
    if (!pointed.snap) return freePointAt(raw, pixel, modifiers, previous);
    pointed.place = pointed.snap->place;
    if (previous && isStraight(modifiers)) pointed.place = straightened(pointed.place, *previous);
    return pointed;
}

/// A point without a snap, rounded to a power of ten below the pixel size. A corner placed by eye would otherwise have
/// 17 digits.
Point Workbench::asSeen(const Point& raw) const {
    const double finer = std::pow(10.0, -std::floor(std::log10(metres(1.0))));  // steps per metre
    const auto one = [&](double metres) {
        // Dividing by an integer gives the number closest to the decimal value, so few digits are written.
        return finer >= 1.0 ? std::round(metres * finer) / finer : std::round(metres * finer) * std::round(1.0 / finer);
    };
    return {one(raw.x()), one(raw.y())};
}

Pointed Workbench::freePointAt(const Point& aimed, const QPointF& pixel, Qt::KeyboardModifiers modifiers,
                               const std::optional<Point>& previous) const {
    look();
    const Point raw = asSeen(aimed);
    const bool straight = previous && isStraight(modifiers);
    Pointed pointed{straight ? straightened(raw, *previous) : raw, raw, {}, pixel, modifiers};
    if (!modes_.gridSnap) return pointed;
    pointed.snap = snaps_->at(pointed.place, {metres(snapReach), false, gridSpacing(), {}, {}});
    if (pointed.snap) pointed.place = pointed.snap->place;
    if (straight) pointed.place = straightened(pointed.place, *previous);
    return pointed;
}

bool Workbench::commit(const QString& step, const Edit& edit) { return document_.apply(step, edit); }

bool Workbench::add(const Edit& edit, const QString& step) {
    const QString made = QString::fromStdString(titleAt(edit.scene, edit.made));
    if (!commit(step.isEmpty() ? tr("Add %1").arg(made) : step, edit)) return false;
    selection_.set({QString::fromStdString(edit.made)});
    return true;
}

void Workbench::say(const QString& text, bool warns) { Q_EMIT said(text, warns); }

}  // namespace keyblock
