// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Painted above the drawing of blocks and bolts in drawing mode: supports, loads,
// monitors, regions, lines that have not been cut yet, and the selection.
#pragma once

#include "ui/canvas/canvas_tool.h"
#include "ui/edit/scene_objects.h"

#include <memory>
#include <vector>

class QPainterPath;

namespace keyblock {

class ToolPainter;
class Workbench;

class SceneOverlay : public CanvasOverlay {
public:
    explicit SceneOverlay(const Workbench& bench) : bench_(bench) {}

    void paint(QPainter& painter, const CanvasMap& map) const override;
    void forget() { shown_.reset(); }

private:
    const std::vector<SceneObject>& objects() const;
    bool isShown() const;  // true if the drawing below shows the current scene
    void paintLines(QPainter& painter, const CanvasMap& map) const;
    QPainterPath rock(const CanvasMap& map) const;
    void paintSelected(QPainter& painter, const CanvasMap& map) const;

    const Workbench& bench_;
    mutable std::shared_ptr<const Scene> shown_;  // the scene of `objects_`, which may be a preview
    mutable std::vector<SceneObject> objects_;
};

}  // namespace keyblock
