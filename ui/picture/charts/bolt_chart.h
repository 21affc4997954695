// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Diagram of one bolt, drawn straight: the bond state at each node, and below it axial
// force, shear force, moment, bond force and slip against the distance from the far
// end, with the envelope over the run to date.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"
#include "ui/picture/section/marks.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Minimum and maximum of a quantity along the bolt over all frames up to the displayed frame. The minimum is at most
/// zero, and the maximum at least zero.
struct Envelope {
    std::string quantity;  // column of the quantity in exported tables
    std::vector<double> s, low, high;  // distance from the far end [m]; values in SI units
};

struct BoltChart {
    std::string title, subtitle;
    double length = 0.0;  // [m]
    std::vector<Mark> band;  // marks drawn along the straight bolt, at (s, 0)
    Chart chart;  // abscissa: distance from the far end [m]
    std::vector<Envelope> envelopes;  // one for each panel with an envelope
};

/// Largest and smallest values along one bolt over all frames added. They determine which panels a diagram shows and
/// the ranges of its axes, so that both stay the same from frame to frame.
class BoltReach {
public:
    explicit BoltReach(int bolt) : bolt_(bolt) {}

    void add(const Frame& frame);

    int bolt() const { return bolt_; }
    ValueRange reached(std::string_view column) const;  // at bonded nodes, including zero and peaks between frames
    double largest(std::string_view column) const;  // largest magnitude along the bar
    double largestForce() const { return largestForce_; }  // largest magnitude of the axial force [N]

private:
    void addPeaks(const Frame& frame);

    int bolt_;
    std::map<std::string_view, ValueRange> reached_;
    std::map<std::string_view, double> largest_;
    double largestForce_ = 0.0;
};

/// Diagram, without envelopes, of the bolt `reach.bolt()` at one frame. The axis ranges cover the values in `reach` and
/// in this frame. No other frame is read.
/// \pre the frame contains the bolt.
BoltChart boltChart(const RunSource& run, std::size_t frame, const BoltReach& reach);

/// Diagram, with envelopes, of the bolt with index `bolt` at one frame. Reads all frames up to this one.
/// \pre the frame contains the bolt.
BoltChart boltChart(const RunSource& run, std::size_t frame, int bolt);

/// Index of the bolt with the largest axial force in the run up to the frame; −1 if there is none.
/// \param held index returned for the previous frame; −1: none. This bolt is returned again unless the largest force of
/// another bolt is more than 1.5 times as large, so that the diagram of a run in progress does not jump between bolts.
int mostLoadedBolt(const Frame& frame, int held = -1);

}  // namespace keyblock
