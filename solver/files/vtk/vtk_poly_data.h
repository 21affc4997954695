// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes VTK's XML format for points, lines and polygons (`.vtp`) without VTK. The
// values are appended to the XML as little-endian binary data, so a reader gets
// exactly the same doubles.
#pragma once

#include "geometry/point.h"

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace keyblock {

/// A named array with `components` values for each point or cell, or values for the whole data set.
struct VtkArray {
    std::string name;
    std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> values;
    int components = 1;
};

/// Cells of one kind as VTK stores them: the point indices of all cells in one list, and the end of each cell in that
/// list.
struct VtkCells {
    std::vector<std::int64_t> points;  // point indices
    std::vector<std::int64_t> ends;

    void add(std::span<const std::int64_t> cell);
};

/// A data set in the plane z = 0. Arrays in `cellData` contain the values of the vertices first, then those of the
/// lines, then those of the polygons.
struct VtkPolyData {
    std::vector<Point> points;  // [m]
    VtkCells vertices, lines, polygons;
    std::vector<VtkArray> pointData, cellData;
    std::vector<VtkArray> fieldData;  // values for the whole data set
};

/// Writes a `.vtp` file: XML with the values appended as raw bytes.
/// \pre each array in `pointData` and `cellData` has `components` values for each point or cell.
void writeVtkPolyData(const VtkPolyData& data, std::ostream& out);

/// One file of a time series, and its time.
struct VtkMoment {
    double time = 0.0;
    std::string file;  // path relative to the folder of the `.pvd` file
};

/// Writes a `.pvd` file, which lists the file of each time.
void writeVtkCollection(std::span<const VtkMoment> moments, std::ostream& out);

}  // namespace keyblock
