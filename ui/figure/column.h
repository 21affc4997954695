// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The column next to a section: colour bars, the key of marks, the list of events. The
// height of each item is known before it is drawn, so that the height of the figure can
// be adapted to its content.
#pragma once

#include "ui/figure/ink.h"
#include "ui/picture/captions.h"
#include "ui/picture/event_list.h"
#include "ui/picture/section/arrows.h"
#include "ui/picture/section/legend.h"
#include "ui/picture/section/marks.h"

#include <functional>
#include <vector>

namespace keyblock {

struct ColumnItem {
    double height = 0.0;  // [mm]
    std::function<void(Ink&, const Point&)> draw;  // draws the item with its upper left corner at the point [mm]
};

inline constexpr double itemGap = 4.2;  // vertical gap between two items [mm]

/// Draws an arrow that starts at `at`, or a bar centred at `at`.
/// \param length the arrow or bar as a vector on paper [mm, y downwards].
void drawArrow(Ink& ink, ArrowShape shape, const Point& at, const Point& length);

// Items for a column of `width` [mm]. The data passed by reference must outlive them.
ColumnItem barItem(const LegendBar& bar, double width);
ColumnItem arrowItem(const ArrowField& field, double scale, double width);
ColumnItem keyItem(std::vector<MarkKind> kinds, double width);
ColumnItem eventsItem(const Scene& scene, const EventList& events, double width);

}  // namespace keyblock
