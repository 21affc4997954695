// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a section of the rock looks like at one moment, decided once for paper and
// screen: plain shapes in metres with the values that colour them. Nothing here
// knows a pixel, a font or a library of windows.
#pragma once

#include "geometry/polygon.h"
#include "solver/results/frame_quantities.h"
#include "solver/results/run_source.h"
#include "ui/picture/arrows.h"
#include "ui/picture/event_list.h"
#include "ui/picture/legend.h"
#include "ui/picture/marks.h"
#include "ui/picture/shown_numbers.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct SectionRequest {
    std::optional<std::size_t> frame;  // null: the scene before anything happened, without results
    const FrameQuantity<BlockState>* blocks = nullptr;  // null: not coloured
    const FrameQuantity<BoltNodeFrame>* bolts = nullptr;  // null: not coloured
    std::optional<ArrowKind> arrows;  // drawn over blocks that are not coloured
    bool contacts = false;  // their forces are drawn over blocks that are not coloured
    bool everyContact = false;  // those outside the window too, for a camera that moves
    std::optional<int> ribbon;  // bolt beside which its values stand; null: the one with the largest
    double factor = 1.0;  // displacements are drawn enlarged by it
    bool whole = false;  // show the whole model, not what surrounds tunnels and bolts
    std::optional<Box> window;  // shown in any case [m]
    std::size_t mostEvents = 12;
    const SectionLegends* legends = nullptr;  // of the run, where they are known; null: its frames are read for them
    ScaleChoices scales{};  // of the quantities
    double ribbonScale = 0.0;  // the ribbon is drawn as for a value of at least this size, in the unit shown
};

struct LineShape {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
};

struct BlockShape {
    int block = -1;  // row of the solved blocks
    std::string name;
    std::vector<Point> outline;  // [m], as drawn
    std::vector<Point> before;  // where it was [m]
    std::optional<double> value;  // in the unit shown
    double displaced = 0.0;  // largest way of a corner, as drawn [m]
    std::vector<char> edgesHidden{};  // an edge each: not drawn as a joint; empty: all are
};

struct BoltShape {
    int bolt = -1;
    std::string name;
    std::vector<Point> nodes;  // from the far end [m], as drawn
    std::vector<double> s;  // of each node [m]
    std::vector<double> values;  // an element each, in the unit shown, with its sign; empty without results
    std::vector<char> broken;  // an element each
    std::vector<Mark> marks;  // all, not thinned
};

/// The values of one bolt to be drawn beside it.
struct Ribbon {
    std::size_t shape = 0;  // index into the bolts drawn
    std::size_t peak = 0;  // element of the largest size
    double scale = 0.0;  // size that takes all of the ribbon's room, in the unit shown
    std::optional<double> limit;  // that the quantity meets, its largest along the bolt, in the unit shown
    std::vector<double> limits;  // the same of each element, 0 where there is none; empty without a limit
    std::string limitName;
};

struct SectionPicture {
    Box model, window;  // [m]: all of it, and what is shown
    std::vector<BlockShape> blocks;  // those that are there
    std::vector<LineShape> walls, borders, seams;  // as drawn
    std::vector<std::vector<Point>> openings;  // profiles of the tunnels [m]; rock that is still there lies over them
    std::vector<BoltShape> bolts;  // those that are there
    std::optional<LegendBar> blockLegend, boltLegend;
    std::optional<ArrowField> arrows;
    std::optional<ContactField> contacts;
    std::optional<Ribbon> ribbon;
    EventList events;
    double factor = 1.0;  // on displacements
    ShownNumbers numbers;  // that its values are in
    std::string title, subtitle;
};

/// \pre the frame lies within the run's frames.
SectionPicture sectionPicture(const RunSource& run, const SectionRequest& request);

}  // namespace keyblock
