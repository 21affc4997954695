// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The layers of a section as plain arrays, before the card sees them. Places are
// told from an origin near by, as the card counts in single precision.
#pragma once

#include "ui/picture/section.h"
#include "ui/view/layer.h"
#include "ui/view/view_colours.h"

#include <vector>

namespace keyblock {

class SectionShapes {
public:
    SectionShapes(const SectionPicture& picture, const Point& origin) : picture_(picture), origin_(origin) {}

    LayerShapes openings() const;
    /// Triangles; corners of each block are its own, so that none shares a colour.
    LayerShapes blocks(const ViewColours& colours, bool drawing) const;
    /// Lines round every block.
    LayerShapes outlines() const;
    /// Lines round the blocks of these rows of the picture.
    LayerShapes outlines(const std::vector<const BlockShape*>& blocks) const;
    LayerShapes lines(const std::vector<LineShape>& lines) const;
    /// Lines along bolts, but for what is broken; coloured where `colours` are given.
    LayerShapes shanks(const ViewColours* colours) const;
    /// Lines along the bolts of these rows of the scene, whole.
    LayerShapes whole(const std::vector<int>& bolts) const;

private:
    void addCorner(LayerShapes& shapes, const Point& place) const;
    void addRing(LayerShapes& shapes, const std::vector<Point>& ring, const std::vector<char>& without = {}) const;
    void addFilled(LayerShapes& shapes, const std::vector<Point>& outline, const std::vector<Point>& tiledBy) const;

    const SectionPicture& picture_;
    Point origin_;
};

}  // namespace keyblock
