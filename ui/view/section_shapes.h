// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The layers of a section as plain arrays, before they are uploaded to the GPU. Points
// are relative to an origin nearby, because the GPU uses single precision.
#pragma once

#include "ui/picture/section/section.h"
#include "ui/view/layer.h"
#include "ui/view/view_colours.h"

#include <vector>

namespace keyblock {

class SectionShapes {
public:
    SectionShapes(const SectionPicture& picture, const Point& origin) : picture_(picture), origin_(origin) {}

    LayerShapes openings() const;
    /// Triangles of the blocks. Blocks share no points, so each can have its own colour.
    /// \param drawing true: all blocks have the colour of rock, because no results are shown.
    LayerShapes blocks(const ViewColours& colours, bool drawing) const;
    /// Outlines of all blocks.
    LayerShapes outlines() const;
    /// Outlines of the given blocks of the picture.
    LayerShapes outlines(const std::vector<const BlockShape*>& blocks) const;
    LayerShapes lines(const std::vector<LineShape>& lines) const;
    /// Lines along the unbroken parts of the bolts. \param colours null: without colours.
    LayerShapes shanks(const ViewColours* colours) const;
    /// Lines along the whole length of the given bolts. \param bolts indices of the bolts in the scene.
    LayerShapes whole(const std::vector<int>& bolts) const;

private:
    void addCorner(LayerShapes& shapes, const Point& place) const;
    void addRing(LayerShapes& shapes, const std::vector<Point>& ring, const std::vector<char>& without = {}) const;
    void addFilled(LayerShapes& shapes, const std::vector<Point>& outline, const std::vector<Point>& tiledBy) const;

    const SectionPicture& picture_;
    Point origin_;
};

}  // namespace keyblock
