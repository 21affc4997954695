// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout of a section and its legends on a sheet: colour bars, key and events are
// arranged in a column next to the section, or in two columns below it if the sheet is
// narrow.
#pragma once

#include "ui/figure/column.h"
#include "ui/picture/section/section.h"

#include <array>
#include <optional>
#include <vector>

namespace keyblock {

class SectionLayout {
public:
    /// \param width width of the sheet [mm]. \param top upper edge of the content [mm]. \param inner width between the
    /// margins [mm]. \param kinds kinds of marks in the key; null: the kinds that are drawn.
    SectionLayout(const SectionPicture& picture, const Scene& scene, double width, double top, double inner,
                  std::optional<std::vector<MarkKind>> kinds = {});

    const Box& map() const { return map_; }  // area of the section [mm]
    double height() const { return height_; }  // total height [mm]
    const std::vector<MarkKind>& kinds() const { return kinds_; }

    /// Draws the section and its legends. `picture` need not be the picture given to the constructor, but its legends
    /// must not need more space.
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
