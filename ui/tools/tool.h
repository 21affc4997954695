// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Base class of the tools. A tool is a mode of working on the section; only one is
// active at a time. `ToolDesk` translates mouse and key events for it (point, Enter,
// Esc). The tool supplies a prompt and its options and paints a preview. The document
// changes only when the tool commits its input as one undo step.
#pragma once

#include "ui/tools/tool_field.h"
#include "ui/tools/workbench.h"

#include <QCursor>
#include <QObject>

#include <optional>
#include <string>
#include <vector>

class QKeyEvent;
class QMenu;
class QPainter;

namespace keyblock {

class CanvasMap;

class Tool : public QObject {
    Q_OBJECT

public:
    explicit Tool(Workbench& bench) : bench_(bench) {}

    virtual QString id() const = 0;  // e.g. `joint`; also names its icon and its command, `tool.joint`
    virtual QString title() const = 0;  // e.g. `Joint`
    virtual QString prompt() const = 0;  // input expected next, e.g. `pick the next point`
    virtual QString detail() const { return {}; }  // input so far, e.g. `3 points, 12.4 m`
    virtual std::vector<ToolField> fields() { return {}; }
    virtual QString commitText() const { return {}; }  // e.g. `Place 8 bolts`; empty: not ready to commit

    virtual void begin() {}  // the tool was chosen
    virtual void end() {}  // another tool was chosen; discards input that is not committed
    virtual void refresh() {}  // the document changed

    // Mouse events, with snapping applied.
    virtual void press(const Pointed&) {}
    virtual void move(const Pointed&) {}
    virtual void release(const Pointed&) {}
    virtual void doubleClick(const Pointed& at) { press(at); }
    virtual void leave() {}

    virtual bool enter() { return false; }  // finishes the input; false: there is nothing to finish
    virtual bool back() { return false; }  // steps back one level (Esc); false: there is nothing to step back from
    virtual bool undoPoint() { return false; }  // removes the last point (Backspace)
    virtual bool close() { return false; }  // closes the outline (C)
    virtual bool key(QKeyEvent&) { return false; }
    virtual void fillMenu(QMenu&, const Pointed&) {}

    virtual bool changes() const { return true; }  // false: read-only
    virtual bool wantsPlaces() const { return true; }  // true: the canvas shows snap points and the coordinate box
    virtual bool snaps() const { return wantsPlaces(); }
    virtual bool accepts(const Snap&) const { return true; }  // false: this tool does not use the snap point
    virtual std::optional<Point> previous() const { return {}; }  // base of relative coordinates and of ortho [m]
    virtual std::vector<std::string> unsnapped() const { return {}; }  // pointers to objects excluded from snapping

    virtual void paint(QPainter&, const CanvasMap&) const {}
    virtual QCursor cursor() const { return Qt::CrossCursor; }

Q_SIGNALS:
    void changed();  // prompt, options or preview changed
    void finished(const QString& next);  // id of the tool to continue with, after a step that ends this one

protected:
    Workbench& bench() const { return bench_; }
    const Scene& scene() const { return bench_.scene(); }

private:
    Workbench& bench_;
};

}  // namespace keyblock
