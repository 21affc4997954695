// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shared by all tools: document, selection and canvas, the point under the mouse (with
// snap, ortho and grid), and the commit of an edit as an undo step.
#pragma once

#include "ui/edit/edit.h"
#include "ui/edit/scene_objects.h"
#include "ui/edit/snap.h"

#include <QObject>
#include <QPointF>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace keyblock {

class Canvas;
class Display;
class Document;
class Selection;
class Themes;
class Visibility;
struct Theme;

/// A point that the user gives to a tool with the mouse or the keyboard.
struct Pointed {
    Point place{0.0, 0.0};  // after snapping [m]
    Point raw{0.0, 0.0};  // position of the mouse, before snapping [m]
    std::optional<Snap> snap{};
    QPointF pixel{};
    Qt::KeyboardModifiers modifiers{};
    bool typed = false;
};

/// Drawing aids that the user switches on and off with keys.
struct PointingModes {
    bool objectSnap = true, ortho = false, gridSnap = false, gridShown = false;

    bool operator==(const PointingModes&) const = default;
};

class Workbench : public QObject {
    Q_OBJECT

public:
    Workbench(Canvas& canvas, Document& document, Selection& selection, const Visibility& visibility,
              const Display& display, const Themes& themes, QObject* parent = nullptr);

    Canvas& canvas() const { return canvas_; }
    Document& document() const { return document_; }
    Selection& selection() const { return selection_; }
    const Display& display() const { return display_; }
    const Theme& theme() const;

    const Scene& scene() const;  // the scene of the document, without a preview
    const std::vector<SceneObject>& objects() const;  // objects of that scene that are not hidden
    bool isHidden(const std::string& pointer) const;
    bool isLocked(const std::string& pointer) const;  // cannot be selected with the mouse
    const SceneObject* object(const QString& pointer) const;  // null: it has no shape, is hidden or does not exist
    double metres(double pixels) const;
    double gridSpacing() const;  // spacing of the grid at the current zoom [m]

    const PointingModes& modes() const { return modes_; }
    void setModes(const PointingModes& modes);

    /// False if the canvas shows results.
    bool isDrawing() const { return drawing_; }
    void setDrawing(bool drawing);

    /// The point at the mouse after snapping. A snap point for which `accepts` returns false is ignored.
    /// \param previous start of the line being drawn, used by ortho and by perpendicular snaps
    /// \param except pointers to objects excluded from snapping
    template <typename Accepts>
    Pointed pointAt(const Point& raw, const QPointF& pixel, Qt::KeyboardModifiers modifiers,
                    const std::optional<Point>& previous, const std::vector<std::string>& except, Accepts accepts) const {
        Pointed pointed = pointAt(raw, pixel, modifiers, previous, except);
        const bool named = pointed.snap && pointed.snap->kind != SnapKind::Grid;
        if (!named || accepts(*pointed.snap)) return pointed;
        return freePointAt(raw, pixel, modifiers, previous);
    }
    Pointed pointAt(const Point& raw, const QPointF& pixel, Qt::KeyboardModifiers modifiers,
                    const std::optional<Point>& previous, const std::vector<std::string>& except) const;

    /// Like `pointAt`, without object snap.
    Pointed freePointAt(const Point& raw, const QPointF& pixel, Qt::KeyboardModifiers modifiers,
                        const std::optional<Point>& previous) const;

    /// Applies the edit as an undo step called `step`. If the edit is refused, shows the reason and returns false.
    bool commit(const QString& step, const Edit& edit);
    /// Applies an edit that creates an object, and selects this object. The undo step is called `step` or, if `step` is
    /// empty, `Add` and the name of the object, e.g. `Add joint J3`. Returns false if the edit is refused.
    bool add(const Edit& edit, const QString& step = {});
    /// Shows a message next to the prompt.
    void say(const QString& text, bool warns = false);

Q_SIGNALS:
    void said(const QString& text, bool warns);
    void modesChanged();
    void drawingChanged();

private:
    void look() const;
    bool isStraight(Qt::KeyboardModifiers modifiers) const;
    Point asSeen(const Point& raw) const;

    Canvas& canvas_;
    Document& document_;
    Selection& selection_;
    const Visibility& visibility_;
    const Display& display_;
    const Themes& themes_;
    PointingModes modes_;
    bool drawing_ = true;
    mutable std::shared_ptr<const Scene> seen_;  // scene from which `objects_` and `snaps_` were made
    mutable std::vector<SceneObject> objects_;
    mutable std::unique_ptr<SnapIndex> snaps_;
};

}  // namespace keyblock
