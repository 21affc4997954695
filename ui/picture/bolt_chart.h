// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One bolt straightened: the state of its bond node by node, and below it axial force,
// shear, moment, bond force and slip on one axis from the far end to the head, with the
// envelope to date.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"
#include "ui/picture/marks.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Minimum and maximum at positions along the bolt over the frames up to the one shown.
struct Envelope {
    std::string quantity;  // its column in tables
    std::vector<double> s, low, high;  // [m], SI
};

struct BoltChart {
    std::string title, subtitle;
    double length = 0.0;  // [m]
    std::vector<Mark> band;  // positions as s
    Chart chart;  // abscissa: s [m]
    std::vector<Envelope> envelopes;  // of the panels that have one
};

/// Ranges of a bolt over the frames added, at any position: panels and axis ranges then stay the same from frame to
/// frame.
class BoltReach {
public:
    explicit BoltReach(int bolt) : bolt_(bolt) {}

    void add(const Frame& frame);

    int bolt() const { return bolt_; }
    ValueRange reached(std::string_view column) const;  // at bonded nodes, including zero
    double largest(std::string_view column) const;  // magnitude, at all nodes
    double largestForce() const { return largestForce_; }  // axial [N]

private:
    void addPeaks(const Frame& frame);

    int bolt_;
    std::map<std::string_view, ValueRange> reached_;
    std::map<std::string_view, double> largest_;
    double largestForce_ = 0.0;
};

/// The same for one frame, with ranges known from earlier frames; without envelopes, and without reading other frames.
/// \pre the frame holds the bolt.
BoltChart boltChart(const RunSource& run, std::size_t frame, const BoltReach& reach);

/// \pre the frame holds the bolt.
BoltChart boltChart(const RunSource& run, std::size_t frame, int bolt);

/// The bolt with the largest axial force in the run up to the frame; −1 if there is none. `held` is the previous
/// choice: it stays until another bolt has carried half as much again, so that the diagram of a run in progress does
/// not jump between bolts.
int mostLoadedBolt(const Frame& frame, int held = -1);

}  // namespace keyblock
