// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ParaView is given of a frame: blocks as polygons, bolts as lines, contacts
// as points, with the same quantities, names and units as the tables have. The
// columns are those of the run store (files/run_store/frame_payload.h) and what the table of
// quantities (results/frame_quantities.h) makes of them, so that a quantity that is
// added to either is exported too.
#pragma once

#include "solver/files/vtk/vtk_poly_data.h"
#include "solver/results/run_source.h"

#include <vector>

namespace keyblock {

/// Blocks of a run and where displacements count from.
class VtkBlocks {
public:
    explicit VtkBlocks(const RunSource& run);

    /// Corners as points, with their displacement since the start or the last `zero_displacements`; blocks as polygons,
    /// a concave one as triangles (VTK fills polygons of few corners as if they were convex), each with the values of
    /// its block. Blocks have no holes: the cut parts rock round an opening. Those that are not there are left out.
    /// \pre frames are requested in order of time, none left out that ends a stage.
    VtkPolyData data(const Frame& frame);

private:
    void zero();
    Point displacementOf(const BlockState& block, std::size_t index, std::size_t corner) const;

    const RunSource& run_;
    std::vector<std::vector<std::vector<int>>> pieces_;  // of each block
    std::vector<std::vector<Point>> reference_;  // corners that displacements count from
    std::vector<std::vector<Point>> last_;  // corners of the last frame
    int stage_ = 0;  // of the last frame
};

/// Nodes as points; elements as lines with their forces, and the plate as a vertex at the last node with its own.
VtkPolyData vtkBolts(const RunSource& run, const Frame& frame);

/// Contacts as vertices.
VtkPolyData vtkContacts(const RunSource& run, const Frame& frame);

}  // namespace keyblock
