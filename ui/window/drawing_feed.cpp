// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/drawing_feed.h"

#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/visibility.h"
#include "ui/document/visible_picture.h"
#include "ui/edit/scene_objects.h"

#include <utility>

namespace keyblock {

namespace {

/// Box around the drawn objects, for scenes without a cut that gives the extent.
std::optional<Box> extentOf(const Scene& scene) {
    using enum ObjectKind;
    std::vector<Point> corners;
    for (const SceneObject& object : objectsOf(scene)) {
        const bool isOfRock = object.kind == Domain || object.kind == Block || object.kind == Tunnel ||
                              object.kind == Joint || object.kind == Bolt;
        if (const auto box = boxOf(object); isOfRock && box) corners.insert(corners.end(), {box->min, box->max});
    }
    return corners.empty() ? std::nullopt : std::optional(boxOf(corners));
}

}  // namespace

DrawingFeed::DrawingFeed(Document& document, const Visibility& visibility, Canvas& canvas, QObject* parent)
    : QObject(parent), document_(document), visibility_(visibility), canvas_(canvas) {
    connect(&visibility, &Visibility::changed, this, &DrawingFeed::show);
    connect(&document, &Document::checkedChanged, this, &DrawingFeed::show);
    // Another document is fitted into the view, whereas an edit keeps the view.
    connect(&document, &Document::replaced, this, [this] {
        isOther_ = true;
        if (on_) canvas_.show(nullptr);
    });
    canvas_.setDrawing(true);
    showHint();
}

void DrawingFeed::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    Q_EMIT switched(on);
    if (!on) return;
    canvas_.setDrawing(true);
    show();
}

void DrawingFeed::show() {
    if (!on_) return;
    if (isOther_ && !document_.checkIsCurrent()) return;  // the check is still that of the previous document
    const Checked& checked = document_.checked();
    const bool broken = hasErrors(checked.problems);
    canvas_.setExtent(broken ? extentOf(*checked.scene) : std::nullopt);
    if (std::exchange(isOther_, false)) {
        canvas_.show(nullptr);
        if (!checked.picture) canvas_.fit();
    }
    showHint();
    // While there are errors, the last valid picture stays; the listed problems say what to do.
    if (checked.picture || !broken) canvas_.show(visiblePicture(checked, visibility_));
}

void DrawingFeed::showHint() {
    const Scene& scene = *document_.checked().scene;
    const bool empty = !scene.domain && scene.blocks.empty();
    if (!empty && hasErrors(document_.checked().problems))
        canvas_.setHint(tr("The scene has errors"),
                        tr("Fix the errors listed under Problems to see the section cut into blocks."), true);
    else
        canvas_.setHint(tr("Nothing has been drawn yet"),
                        tr("Draw the outline of the rock first, then joints and a tunnel."));
}

}  // namespace keyblock
