// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The XML part states, for each array, where its bytes begin after the mark `_` of the
// appended part. The number of bytes comes first, followed by the bytes themselves.
// The bytes are collected first and written in the same order.
#include "solver/files/vtk/vtk_poly_data.h"

#include "solver/scene/number_text.h"
#include "solver/scene/xml_text.h"

#include <array>
#include <bit>
#include <cstring>

namespace keyblock {

namespace {

template <typename Number>
void appendBytes(std::string& bytes, Number number) {
    static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");
    std::array<char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), &number, sizeof(Number));
    bytes.append(raw.data(), raw.size());
}

std::string bytesOf(const std::vector<std::string>& texts) {
    std::string bytes;
    for (const std::string& text : texts) bytes += text.substr(0, text.find('\0')) + '\0';
    return bytes;
}

template <typename Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    std::string bytes;
    bytes.reserve(numbers.size() * sizeof(Number));
    for (const Number number : numbers) appendBytes(bytes, number);
    return bytes;
}

std::string_view typeOf(const std::vector<double>&) { return "Float64"; }
std::string_view typeOf(const std::vector<std::int32_t>&) { return "Int32"; }
std::string_view typeOf(const std::vector<std::int64_t>&) { return "Int64"; }
std::string_view typeOf(const std::vector<std::string>&) { return "String"; }

class Writer {
public:
    void write(const VtkPolyData& data, std::ostream& out) {
        const std::size_t cells = data.vertices.ends.size() + data.lines.ends.size() + data.polygons.ends.size();
        xml_ = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\">\n<PolyData>\n";
        addArrays("FieldData", data.fieldData, true);
        xml_ += "<Piece NumberOfPoints=\"" + std::to_string(data.points.size()) + "\" NumberOfVerts=\"" +
                std::to_string(data.vertices.ends.size()) + "\" NumberOfLines=\"" +
                std::to_string(data.lines.ends.size()) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
                std::to_string(data.polygons.ends.size()) + "\">\n";
        if (!data.points.empty()) addArrays("PointData", data.pointData, false);
        if (cells > 0) addArrays("CellData", data.cellData, false);
        addPoints(data.points);
        addCells("Verts", data.vertices);
        addCells("Lines", data.lines);
        addCells("Polys", data.polygons);
        out << xml_ << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" << appended_
            << "\n</AppendedData>\n</VTKFile>\n";
    }

private:
    void addArrays(const std::string& element, const std::vector<VtkArray>& arrays, bool withCount) {
        xml_ += "<" + element + ">\n";
        for (const VtkArray& array : arrays)
            std::visit([&](const auto& values) { addArray(array.name, values, array.components, withCount); },
                       array.values);
        xml_ += "</" + element + ">\n";
    }

    void addPoints(const std::vector<Point>& points) {
        std::vector<double> values;
        values.reserve(3 * points.size());
        for (const Point& p : points) values.insert(values.end(), {p.x(), p.y(), 0.0});
        xml_ += "<Points>\n";
        addArray("Points", values, 3, false);
        xml_ += "</Points>\n";
    }

    void addCells(const std::string& element, const VtkCells& cells) {
        xml_ += "<" + element + ">\n";
        addArray("connectivity", cells.points, 1, false);
        addArray("offsets", cells.ends, 1, false);
        xml_ += "</" + element + ">\n";
    }

    template <typename Values>
    void addArray(const std::string& name, const Values& values, int components, bool withCount) {
        xml_ += "<DataArray type=\"" + std::string(typeOf(values)) + "\" Name=\"" + xmlText(name) + "\"";
        if (components > 1) xml_ += " NumberOfComponents=\"" + std::to_string(components) + "\"";
        if (withCount) xml_ += " NumberOfTuples=\"" + std::to_string(values.size()) + "\"";
        xml_ += " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
        const std::string bytes = bytesOf(values);
        appendBytes(appended_, static_cast<std::uint64_t>(bytes.size()));
        appended_ += bytes;
    }

    std::string xml_;
    std::string appended_;
};

}  // namespace

void VtkCells::add(std::span<const std::int64_t> cell) {
    points.insert(points.end(), cell.begin(), cell.end());
    ends.push_back(static_cast<std::int64_t>(points.size()));
}

void writeVtkPolyData(const VtkPolyData& data, std::ostream& out) { Writer().write(data, out); }

void writeVtkCollection(std::span<const VtkMoment> moments, std::ostream& out) {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           "<Collection>\n";
    for (const VtkMoment& moment : moments)
        out << "<DataSet timestep=\"" << shortest(moment.time) << "\" part=\"0\" file=\"" << xmlText(moment.file)
            << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
}

}  // namespace keyblock
