// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout of the section and its legends on a sheet: bars, key and events in a column
// next to it, or in two below it on a narrow sheet.
#pragma once

#include "ui/figure/column.h"
#include "ui/picture/section.h"

#include <array>
#include <optional>
#include <vector>

namespace keyblock {

class SectionLayout {
public:
    /// Layout of this picture on a sheet of `width`, of which `inner` [mm] are within its margins, from `top` down.
    /// `kinds`: marks in the key; null: those that are drawn.
    SectionLayout(const SectionPicture& picture, const Scene& scene, double width, double top, double inner,
                  std::optional<std::vector<MarkKind>> kinds = {});

    const Box& map() const { return map_; }  // of the section [mm]
    double height() const { return height_; }  // total [mm]
    const std::vector<MarkKind>& kinds() const { return kinds_; }

    /// Draws section and column of this picture or of one with no more in its column.
    void draw(Ink& ink, const SectionPicture& picture, const Scene& scene) const;

private:
    using Items = std::array<std::optional<ColumnItem>, 4>;  // bars of blocks and bolts, key, events

    Items itemsOf(const SectionPicture& picture, const Scene& scene) const;
    static double columnHeight(const Items& items);
    void place(const Items& items);

    double inner_;
    bool beside_;
    double columnWidth_ = 0.0, height_ = 0.0;
    Box map_;
    std::vector<MarkKind> kinds_;
    std::array<Point, 4> corners_;
};

}  // namespace keyblock
