// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tool is a mode of working on the section, one at a time. The desk translates
// mouse and key events for it (a point, enter, back); the tool provides the prompt
// and its options, and paints a preview. Nothing reaches the document before it is
// committed as one undo step.
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

    virtual QString id() const = 0;  // joint; also the name of its icon and of its command tool.joint
    virtual QString title() const = 0;  // Joint
    virtual QString prompt() const = 0;  // the next input: `pick the next point`
    virtual QString detail() const { return {}; }  // the input so far: `3 points, 12.4 m`
    virtual std::vector<ToolField> fields() { return {}; }
    virtual QString commitText() const { return {}; }  // `Place 8 bolts`; empty: not ready

    virtual void begin() {}  // was chosen
    virtual void end() {}  // another tool is active; drops what is not committed
    virtual void refresh() {}  // the document changed

    // the mouse, snapped
    virtual void press(const Pointed&) {}
    virtual void move(const Pointed&) {}
    virtual void release(const Pointed&) {}
    virtual void doubleClick(const Pointed& at) { press(at); }
    virtual void leave() {}

    virtual bool enter() { return false; }  // finishes; false: nothing to finish
    virtual bool back() { return false; }  // one level (Esc); false: nothing to step back from
    virtual bool undoPoint() { return false; }  // the last point (Backspace)
    virtual bool close() { return false; }  // the outline (C)
    virtual bool key(QKeyEvent&) { return false; }
    virtual void fillMenu(QMenu&, const Pointed&) {}

    virtual bool changes() const { return true; }  // false: it is read-only
    virtual bool wantsPlaces() const { return true; }  // shows snaps and the coordinate box
    virtual bool snaps() const { return wantsPlaces(); }
    virtual bool accepts(const Snap&) const { return true; }  // false: no snap there for this tool
    virtual std::optional<Point> previous() const { return {}; }  // base of @ and ortho [m]
    virtual std::vector<std::string> unsnapped() const { return {}; }  // pointers excluded from snapping

    virtual void paint(QPainter&, const CanvasMap&) const {}
    virtual QCursor cursor() const { return Qt::CrossCursor; }

Q_SIGNALS:
    void changed();  // prompt, fields, what is painted
    void finished(const QString& next);  // the next tool: after a step that ends this one

protected:
    Workbench& bench() const { return bench_; }
    const Scene& scene() const { return bench_.scene(); }

private:
    Workbench& bench_;
};

}  // namespace keyblock
