// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The object at a point of a section, for hover, probe and selection: found from the
// shapes of the picture, so that it needs no GPU and matches the drawing.
#pragma once

#include "geometry/grid.h"
#include "ui/picture/section.h"

#include <memory>
#include <optional>

namespace keyblock {

enum class PickKind { Block, Bolt, Node };

struct Pick {
    PickKind kind = PickKind::Block;
    int block = -1;  // row of the solved blocks; for a bolt or node, of the block below it
    int bolt = -1;  // row of the scene's bolts
    int node = -1, element = -1;  // nearest of the bolt, from 0 at the far end
    std::size_t shape = 0;  // index into the picture's blocks, or bolts for a bolt or node
};

class PickIndex {
public:
    explicit PickIndex(std::shared_ptr<const SectionPicture> picture);

    /// The node, else the bolt within `reach` [m], else the block that contains the point; objects drawn last come
    /// first.
    std::optional<Pick> at(const Point& place, double reach) const;

private:
    std::optional<Pick> boltAt(const Point& place, double reach) const;
    std::optional<Pick> blockAt(const Point& place) const;

    std::shared_ptr<const SectionPicture> picture_;
    BoxGrid blocks_, bolts_;
};

}  // namespace keyblock
