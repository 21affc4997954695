// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the object at a point of a section, for hover, probe and selection. The search
// uses the drawn shapes, so it needs no GPU and always agrees with the drawing.
#pragma once

#include "geometry/grid.h"
#include "ui/picture/section/section.h"

#include <memory>
#include <optional>

namespace keyblock {

enum class PickKind { Block, Bolt, Node };

struct Pick {
    PickKind kind = PickKind::Block;
    int block = -1;  // row of the solved blocks; for a bolt or a node, the block it lies in
    int bolt = -1;  // row of the scene's bolts
    int node = -1, element = -1;  // nearest node and element of the bolt, counted from 0 at the far end
    std::size_t shape = 0;  // index into the section's drawn blocks, or bolts for a bolt or a node
};

class PickIndex {
public:
    explicit PickIndex(std::shared_ptr<const SectionPicture> picture);

    /// The object at the point. This is the nearest bolt within `reach` [m], or the nearest node of this bolt if it is
    /// also within `reach`. If there is no such bolt, it is the block that contains the point; if several do, the one
    /// drawn last. Null if there is no object.
    std::optional<Pick> at(const Point& place, double reach) const;

private:
    std::optional<Pick> boltAt(const Point& place, double reach) const;
    std::optional<Pick> blockAt(const Point& place) const;

    std::shared_ptr<const SectionPicture> picture_;
    BoxGrid blocks_, bolts_;
};

}  // namespace keyblock
