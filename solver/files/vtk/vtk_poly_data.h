// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// VTK's XML format for points, lines and polygons (`.vtp`), written without VTK.
// Values follow the XML as they are in memory of a little-endian machine, so a
// reader gets the same doubles.
#pragma once

#include "geometry/point.h"

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace keyblock {

/// Values by point or by cell, `components` of them for each.
struct VtkArray {
    std::string name;
    std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> values;
    int components = 1;
};

/// Cells of one kind as VTK lists them: the points of all, and where each ends among them.
struct VtkCells {
    std::vector<std::int64_t> points;  // indices
    std::vector<std::int64_t> ends;

    void add(std::span<const std::int64_t> cell);
};

/// A data set in the plane z = 0. Cell arrays hold the vertices first, then the lines, then the polygons.
struct VtkPolyData {
    std::vector<Point> points;  // [m]
    VtkCells vertices, lines, polygons;
    std::vector<VtkArray> pointData, cellData;
    std::vector<VtkArray> fieldData;  // of the whole data set
};

/// Writes a `.vtp` file: XML with the values appended as raw bytes.
/// \pre arrays have a value, or `components` of them, for each point or cell.
void writeVtkPolyData(const VtkPolyData& data, std::ostream& out);

/// A file of a time series.
struct VtkMoment {
    double time = 0.0;
    std::string file;  // from the folder of the list
};

/// Writes a `.pvd` file, which lists a data set for each moment.
void writeVtkCollection(std::span<const VtkMoment> moments, std::ostream& out);

}  // namespace keyblock
