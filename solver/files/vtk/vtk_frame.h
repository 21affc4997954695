// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A frame as data sets for ParaView: blocks as polygons, bolts as lines, contacts as
// points, with the quantities, names and units of the tables. The data are the columns
// of the run store (files/run_store/frame_payload.h) and the quantities derived from
// them (results/frame_quantities.h), so that a quantity added to either list is
// exported as well.
#pragma once

#include "solver/files/vtk/vtk_poly_data.h"
#include "solver/results/run_source.h"

#include <vector>

namespace keyblock {

/// Converts the blocks of a run's frames to data sets. Keeps the positions from which displacements are measured.
class VtkBlocks {
public:
    explicit VtkBlocks(const RunSource& run);

    /// The blocks of a frame: corners as points with their displacements since the start or the last
    /// `zero_displacements`, and blocks as polygons with their values. A concave block is divided into triangles,
    /// because VTK fills polygons with few corners as if they were convex. Blocks have no holes, because cutting
    /// divides the rock around an opening. Inactive blocks are left out.
    /// \pre frames are passed in order of time, including the last frame of every stage.
    VtkPolyData data(const Frame& frame);

private:
    void zero();
    Point displacementOf(const BlockState& block, std::size_t index, std::size_t corner) const;

    const RunSource& run_;
    std::vector<std::vector<std::vector<int>>> pieces_;  // convex pieces of each block, as indices of its corners
    std::vector<std::vector<Point>> reference_;  // corner positions from which displacements are measured
    std::vector<std::vector<Point>> last_;  // corners in the last frame
    int stage_ = 0;  // stage of the last frame
};

/// The bolts of a frame with their forces: nodes as points, elements as lines, and face plates as vertices at the last
/// nodes.
VtkPolyData vtkBolts(const RunSource& run, const Frame& frame);

/// The contacts of a frame as vertices with their values.
VtkPolyData vtkContacts(const RunSource& run, const Frame& frame);

}  // namespace keyblock
