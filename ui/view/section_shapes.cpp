// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/section_shapes.h"

#include "geometry/cells/convex_pieces.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

void addColour(LayerShapes& shapes, const Colour& colour, std::size_t corners) {
    for (std::size_t i = 0; i < corners; ++i)
        shapes.colours.insert(shapes.colours.end(), {colour.red, colour.green, colour.blue});
}

int cornersOf(const LayerShapes& shapes) { return static_cast<int>(shapes.corners.size() / 2); }

}  // namespace

void SectionShapes::addCorner(LayerShapes& shapes, const Point& place) const {
    shapes.corners.push_back(static_cast<float>(place.x() - origin_.x()));
    shapes.corners.push_back(static_cast<float>(place.y() - origin_.y()));
}

void SectionShapes::addRing(LayerShapes& shapes, const std::vector<Point>& ring,
                            const std::vector<char>& without) const {
    const int first = cornersOf(shapes), count = static_cast<int>(ring.size());
    for (const Point& corner : ring) addCorner(shapes, corner);
    for (int i = 0; i < count; ++i) {
        if (!without.empty() && without[i]) continue;
        shapes.cells.push_back(first + i);
        shapes.cells.push_back(first + (i + 1) % count);
    }
}

/// Blocks deform by affine maps, so the triangulation of their initial shape stays valid.
void SectionShapes::addFilled(LayerShapes& shapes, const std::vector<Point>& outline,
                              const std::vector<Point>& tiledBy) const {
    if (outline.size() < 3 || outline.size() != tiledBy.size()) return;
    const int first = cornersOf(shapes);
    for (const Point& corner : outline) addCorner(shapes, corner);
    for (const std::vector<int>& piece : convexPieces(tiledBy))
        for (std::size_t i = 1; i + 1 < piece.size(); ++i)
            for (const std::size_t corner : {std::size_t{0}, i, i + 1}) shapes.cells.push_back(first + piece[corner]);
}

LayerShapes SectionShapes::openings() const {
    LayerShapes shapes;
    for (const std::vector<Point>& opening : picture_.openings) {
        const std::vector<Point> ring = counterClockwise(opening);
        addFilled(shapes, ring, ring);
    }
    return shapes;
}

LayerShapes SectionShapes::blocks(const ViewColours& colours, bool drawing) const {
    LayerShapes shapes;
    for (const BlockShape& block : picture_.blocks) {
        const bool plain = drawing || !block.value || !picture_.blockLegend;
        addFilled(shapes, block.outline, block.before);
        const bool byActivity = !drawing && block.activity;
        addColour(shapes,
                  byActivity ? colourOf(*block.activity, colours.dark)
                  : plain    ? colours.rock
                             : picture_.blockLegend->colourOf(*block.value, colours.dark),
                  shapes.corners.size() / 2 - shapes.colours.size() / 3);
    }
    return shapes;
}

LayerShapes SectionShapes::outlines() const {
    LayerShapes shapes;
    for (const BlockShape& block : picture_.blocks) addRing(shapes, block.outline, block.edgesHidden);
    return shapes;
}

LayerShapes SectionShapes::outlines(const std::vector<const BlockShape*>& blocks) const {
    LayerShapes shapes;
    for (const BlockShape* block : blocks) addRing(shapes, block->outline);
    return shapes;
}

LayerShapes SectionShapes::lines(const std::vector<LineShape>& lines) const {
    LayerShapes shapes;
    for (const LineShape& line : lines) {
        shapes.cells.push_back(cornersOf(shapes));
        shapes.cells.push_back(cornersOf(shapes) + 1);
        addCorner(shapes, line.from);
        addCorner(shapes, line.to);
    }
    return shapes;
}

LayerShapes SectionShapes::shanks(const ViewColours* colours) const {
    LayerShapes shapes;
    for (const BoltShape& bolt : picture_.bolts)
        for (std::size_t e = 0; e + 1 < bolt.nodes.size(); ++e) {
            if (bolt.broken[e]) continue;
            shapes.cells.push_back(cornersOf(shapes));
            shapes.cells.push_back(cornersOf(shapes) + 1);
            addCorner(shapes, bolt.nodes[e]);
            addCorner(shapes, bolt.nodes[e + 1]);
            if (!colours) continue;
            const bool plain = bolt.values.empty() || !picture_.boltLegend;
            addColour(shapes, plain ? colours->quiet
                                    : picture_.boltLegend->colourOf(std::abs(bolt.values[e]), colours->dark), 2);
        }
    return shapes;
}

LayerShapes SectionShapes::whole(const std::vector<int>& bolts) const {
    std::vector<LineShape> parts;
    for (const BoltShape& bolt : picture_.bolts)
        if (std::find(bolts.begin(), bolts.end(), bolt.bolt) != bolts.end())
            for (std::size_t e = 0; e + 1 < bolt.nodes.size(); ++e) parts.push_back({bolt.nodes[e], bolt.nodes[e + 1]});
    return lines(parts);
}

}  // namespace keyblock
