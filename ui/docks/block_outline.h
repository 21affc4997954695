// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The block that somebody asked to see, outlined on the canvas as the look's page
// says of culprits, with its name.
#pragma once

#include "ui/canvas/canvas_tool.h"

#include <QString>

namespace keyblock {

class Canvas;
class Themes;

class BlockOutline : public CanvasOverlay {
public:
    BlockOutline(const Themes& themes, const Canvas& canvas) : themes_(themes), canvas_(canvas) {}

    void show(int block) { block_ = block; }  // row of the solved blocks; −1: none
    int block() const { return block_; }
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    const Themes& themes_;
    const Canvas& canvas_;
    int block_ = -1;
};

}  // namespace keyblock
