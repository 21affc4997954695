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

#include <string>
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

/// \pre the frame holds the bolt.
BoltChart boltChart(const RunSource& run, std::size_t frame, int bolt);

/// The bolt with the largest axial force in the frame; −1 when it holds none.
int mostLoadedBolt(const Frame& frame);

}  // namespace keyblock
