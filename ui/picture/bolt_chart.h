// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One bolt straightened: the state of its bond node by node, and below it axial
// force, shear, moment, bond force and slip on one axis from the far end to the
// head, with what each place has been through until now.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"
#include "ui/picture/marks.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Least and largest value at places along the bolt over the frames until the one shown.
struct Envelope {
    std::string quantity;  // its column in tables
    std::vector<double> s, low, high;  // [m], SI
};

struct BoltChart {
    std::string title, subtitle;
    double length = 0.0;  // [m]
    std::vector<Mark> band;  // places as s
    Chart chart;  // abscissa: s [m]
    std::vector<Envelope> envelopes;  // of the panels that have one
};

/// What a bolt has been through in frames, of any of its places: for panels and ranges that stay from moment to moment.
class BoltReach {
public:
    explicit BoltReach(int bolt) : bolt_(bolt) {}

    void add(const Frame& frame);

    int bolt() const { return bolt_; }
    ValueRange reached(std::string_view column) const;  // at real nodes, with zero
    double largest(std::string_view column) const;  // size, at all nodes
    double largestForce() const { return largestForce_; }  // axial [N]

private:
    void addPeaks(const Frame& frame);

    int bolt_;
    std::map<std::string_view, ValueRange> reached_;
    std::map<std::string_view, double> largest_;
    double largestForce_ = 0.0;
};

/// The same of one frame, with ranges of what the bolt has been through; without envelopes, and no other frame is read.
/// \pre the frame holds the bolt.
BoltChart boltChart(const RunSource& run, std::size_t frame, const BoltReach& reach);

/// \pre the frame holds the bolt.
BoltChart boltChart(const RunSource& run, std::size_t frame, int bolt);

/// The bolt with the largest axial force in the run until the frame; −1 when it holds none. A bolt that is `held` stays
/// until another has carried half as much again, so that a run that is watched does not jump between bolts.
int mostLoadedBolt(const Frame& frame, int held = -1);

}  // namespace keyblock
