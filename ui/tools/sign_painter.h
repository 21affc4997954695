// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Symbols for supports, loads, motions and monitors as in structural drawings: hatching
// of fixed sides, rollers, arrows, targets.
#pragma once

#include "ui/edit/scene_objects.h"

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace keyblock {

class CanvasMap;
struct Theme;

class SignPainter {
public:
    SignPainter(QPainter& painter, const CanvasMap& map, const Theme& theme);

    /// Paints the symbol of the object; does nothing if it has no symbol.
    void paint(const Scene& scene, const SceneObject& object);

    /// Paints the names of the monitors painted so far, clear of their symbols and of each other.
    void paintNames();

    // Single symbols, for previews.
    void side(const Point& from, const Point& to, Fix fix, const QColor& colour);
    void held(const Point& place, Fix fix, const QColor& colour);
    /// An arrow of length `pixels` [px] with its tip at `place`, pointing in the direction `way`.
    void arrow(const Point& place, const Point& way, double pixels, const QColor& colour);
    void pressure(const Point& from, const Point& to, bool pulls, const QColor& colour);
    void motion(const Point& place, const Point& axis, const QColor& colour);
    void monitor(const Point& place, const QString& name, const QColor& colour);

private:
    struct Name {
        QPointF at;
        QString text;
        QColor colour;
    };

    void support(const Support& support, const SceneObject& object);
    void load(const Load& load);
    void head(const QPointF& tip, const QPointF& along, const QColor& colour);
    std::optional<QRectF> freeBox(const QPointF& at, const QSizeF& size);

    QPainter& painter_;
    const CanvasMap& map_;
    const Theme& theme_;
    std::vector<Name> names_;  // not yet painted
    std::vector<QRectF> taken_;  // places of monitors and names
};

}  // namespace keyblock
