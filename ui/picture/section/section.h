// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawing data of a section at one time, prepared once for paper and screen: plain
// shapes in metres with the values that determine their colours. This code is
// independent of pixels, fonts and GUI libraries.
#pragma once

#include "geometry/polygon.h"
#include "solver/results/frame_quantities.h"
#include "solver/results/run_source.h"
#include "ui/picture/event_list.h"
#include "ui/picture/section/activity.h"
#include "ui/picture/section/arrows.h"
#include "ui/picture/section/legend.h"
#include "ui/picture/section/marks.h"
#include "ui/picture/section/shown_numbers.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct SectionRequest {
    std::optional<std::size_t> frame;  // null: the scene before the run, without results
    const FrameQuantity<BlockState>* blocks = nullptr;  // null: not coloured
    const FrameQuantity<BoltNodeFrame>* bolts = nullptr;  // null: not coloured
    std::optional<ArrowKind> arrows;  // drawn over blocks that are not coloured
    bool contacts = false;  // draw contact forces, over blocks that are not coloured
    bool everyContact = false;  // include contact forces outside the window, for a view that can be panned
    bool activity = false;  // colour blocks by what a step models, instead of by a quantity
    std::optional<int> ribbon;  // bolt with the force diagram; null: the bolt with the largest value
    double factor = 1.0;  // scale factor of displacements
    bool whole = false;  // show the whole model, not only the surroundings of tunnels and bolts
    std::optional<Box> window;  // part to show [m]; null: according to `whole`
    std::size_t mostEvents = 12;  // maximum number of events listed
    const SectionLegends* legends = nullptr;  // legends of the run, if known; null: all frames are read to compute them
    ScaleChoices scales{};  // colour ranges of the quantities
    double ribbonScale = 0.0;  // the scale of the force diagram covers at least this value, in the display unit
};

struct LineShape {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
};

struct BlockShape {
    int block = -1;  // row of the solved blocks
    std::string name;
    std::vector<Point> outline;  // as drawn [m]
    std::vector<Point> before;  // initial corners [m]
    std::optional<double> value;  // in the display unit; null: not coloured
    double displaced = 0.0;  // largest displacement of a corner, as drawn [m]
    std::vector<char> edgesHidden{};  // one per edge: not drawn as a joint; empty: all edges are drawn
    std::optional<BlockActivity> activity{};  // null: not coloured by it
};

struct BoltShape {
    int bolt = -1;
    std::string name;
    std::vector<Point> nodes;  // positions as drawn, starting at the far end [m]
    std::vector<double> s;  // distance of each node from the far end [m]
    std::vector<double> values;  // one per element, in the display unit and with sign; empty: no results
    std::vector<char> broken;  // one per element: ruptured or lost
    std::vector<Mark> marks;  // all marks, not thinned out
};

/// The force diagram of one bolt.
struct Ribbon {
    std::size_t shape = 0;  // index into `SectionPicture::bolts`
    std::size_t peak = 0;  // element with the value of largest magnitude
    double scale = 0.0;  // value drawn with the full width of the diagram, in the display unit
    std::optional<double> limit;  // largest limit along the bolt, in the display unit; null: none
    std::vector<double> limits;  // limit of each element, 0 if it has none; empty: no limit
    std::string limitName;
};

struct SectionPicture {
    Box model, window;  // whole model, and the part shown [m]
    std::vector<BlockShape> blocks;  // blocks that exist at this time
    std::vector<LineShape> walls, borders, seams;  // as drawn
    std::vector<std::vector<Point>> openings;  // tunnel profiles [m]; blocks not yet excavated are drawn over them
    std::vector<BoltShape> bolts;  // bolts that exist at this time
    std::optional<LegendBar> blockLegend, boltLegend;
    std::optional<ActivityCounts> activity;  // null: blocks are not coloured by it
    std::optional<ArrowField> arrows;
    std::optional<ContactField> contacts;
    std::optional<Ribbon> ribbon;
    EventList events;
    double factor = 1.0;  // scale factor of displacements
    ShownNumbers numbers;  // units and sign convention of the values
    std::string title, subtitle;
    std::string notFinite{};  // says what is not shown because it is not finite; empty: everything is
};

/// Drawing data of the requested section. \pre `request.frame` is null or the index of a frame of the run.
SectionPicture sectionPicture(const RunSource& run, const SectionRequest& request);

}  // namespace keyblock
