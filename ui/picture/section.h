// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section of the rock at one time, prepared once for paper and screen: plain shapes
// in metres with the values that colour them. This code is independent of pixels, fonts
// and GUI libraries.
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
    std::optional<std::size_t> frame;  // null: the scene before the run, without results
    const FrameQuantity<BlockState>* blocks = nullptr;  // null: not coloured
    const FrameQuantity<BoltNodeFrame>* bolts = nullptr;  // null: not coloured
    std::optional<ArrowKind> arrows;  // drawn over blocks that are not coloured
    bool contacts = false;  // their forces are drawn over blocks that are not coloured
    bool everyContact = false;  // also those outside the window, for a view that moves
    std::optional<int> ribbon;  // bolt with the force diagram; null: the one with the largest
    double factor = 1.0;  // scale factor of displacements
    bool whole = false;  // show the whole model, not the surroundings of tunnels and bolts
    std::optional<Box> window;  // always shown [m]
    std::size_t mostEvents = 12;
    const SectionLegends* legends = nullptr;  // of the run, if known; null: its frames are read for them
    ScaleChoices scales{};  // of the quantities
    double ribbonScale = 0.0;  // the force diagram is scaled for at least this value, in the unit shown
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
    double displaced = 0.0;  // largest displacement of a corner, as drawn [m]
    std::vector<char> edgesHidden{};  // one per edge: not drawn as a joint; empty: all are
};

struct BoltShape {
    int bolt = -1;
    std::string name;
    std::vector<Point> nodes;  // from the far end [m], as drawn
    std::vector<double> s;  // of each node [m]
    std::vector<double> values;  // one per element, in the unit shown, with its sign; empty without results
    std::vector<char> broken;  // one per element
    std::vector<Mark> marks;  // all, not thinned
};

/// The force diagram of one bolt.
struct Ribbon {
    std::size_t shape = 0;  // index into the bolts drawn
    std::size_t peak = 0;  // element of the largest size
    double scale = 0.0;  // value that fills the diagram's width, in the unit shown
    std::optional<double> limit;  // of the quantity, its largest along the bolt, in the unit shown
    std::vector<double> limits;  // the same for each element, 0 if there is none; empty without a limit
    std::string limitName;
};

struct SectionPicture {
    Box model, window;  // [m]: all of it, and what is shown
    std::vector<BlockShape> blocks;  // those that exist at this time
    std::vector<LineShape> walls, borders, seams;  // as drawn
    std::vector<std::vector<Point>> openings;  // profiles of the tunnels [m]; rock not yet excavated covers them
    std::vector<BoltShape> bolts;  // those that exist at this time
    std::optional<LegendBar> blockLegend, boltLegend;
    std::optional<ArrowField> arrows;
    std::optional<ContactField> contacts;
    std::optional<Ribbon> ribbon;
    EventList events;
    double factor = 1.0;  // scale factor of displacements
    ShownNumbers numbers;  // of its values
    std::string title, subtitle;
};

/// \pre the frame lies within the run's frames.
SectionPicture sectionPicture(const RunSource& run, const SectionRequest& request);

}  // namespace keyblock
