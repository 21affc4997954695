// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/vtk/vtk_frame.h"

#include "geometry/cells/convex_pieces.h"
#include "geometry/polygon.h"
#include "solver/files/run_store/frame_payload.h"
#include "solver/results/frame_quantities.h"
#include "solver/results/result_names.h"
#include "solver/scene/solved_blocks.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

/// Name of a quantity as in the tables: `sxx_Pa`, `vx_m_per_s`, `moment_Nm`.
std::string arrayName(const PayloadColumn& column) {
    if (column.unit.empty()) return std::string(column.name);
    std::string unit;
    for (const char c : column.unit)
        if (c == '/')
            unit += "_per_";
        else if (c != ' ')
            unit += c;
    return std::string(column.name) + "_" + unit;
}

/// The rows of a payload.
class Rows {
public:
    Rows(Payload payload, const Frame& frame)
        : columns_(payloadColumns(payload)), values_(pack(payload, frame)) {}

    double value(std::size_t row, std::size_t column) const { return values_[row * columns_.size() + column]; }
    std::size_t size() const { return values_.size() / columns_.size(); }

    std::size_t columnOf(std::string_view name) const {
        const auto found = std::find_if(columns_.begin(), columns_.end(),
                                        [&](const PayloadColumn& column) { return column.name == name; });
        return found - columns_.begin();
    }

    /// The values of a column for these rows, in this order; a column without a unit contains indices or codes.
    VtkArray array(std::size_t column, const std::vector<std::size_t>& rows) const {
        VtkArray result{arrayName(columns_[column]), {}};
        if (columns_[column].unit.empty()) {
            auto& values = result.values.emplace<std::vector<std::int32_t>>();
            for (const std::size_t row : rows) values.push_back(static_cast<std::int32_t>(value(row, column)));
        } else {
            auto& values = result.values.emplace<std::vector<double>>();
            for (const std::size_t row : rows) values.push_back(value(row, column));
        }
        return result;
    }

    /// Adds all columns except those named.
    void addAll(const std::vector<std::size_t>& rows, const std::vector<std::string_view>& but,
                std::vector<VtkArray>& arrays) const {
        for (std::size_t column = 0; column < columns_.size(); ++column)
            if (std::find(but.begin(), but.end(), columns_[column].name) == but.end())
                arrays.push_back(array(column, rows));
    }

    /// Two columns as a 3D vector, which arrows and deformed shapes require.
    VtkArray vector(const std::string& name, std::string_view x, std::string_view y,
                    const std::vector<std::size_t>& rows) const {
        std::vector<double> values;
        for (const std::size_t row : rows)
            values.insert(values.end(), {value(row, columnOf(x)), value(row, columnOf(y)), 0.0});
        return {name, std::move(values), 3};
    }

private:
    std::span<const PayloadColumn> columns_;
    std::vector<double> values_;
};

/// Adds quantities that are not stored directly, such as principal stresses.
/// \param items the items of the frame.
template <typename Item>
void addDerived(std::span<const FrameQuantity<Item>> quantities, const std::vector<Item>& items,
                const std::vector<std::size_t>& rows, std::vector<VtkArray>& arrays) {
    for (const FrameQuantity<Item>& quantity : quantities) {
        const bool there = std::any_of(arrays.begin(), arrays.end(),
                                       [&](const VtkArray& array) { return array.name == quantity.column; });
        if (there) continue;
        std::vector<double> values;
        for (const std::size_t row : rows) values.push_back(quantity.value(items[row]));
        arrays.push_back({std::string(quantity.column), std::move(values)});
    }
}

std::vector<std::size_t> all(std::size_t count) {
    std::vector<std::size_t> rows(count);
    for (std::size_t i = 0; i < count; ++i) rows[i] = i;
    return rows;
}

VtkArray namesOf(std::string name, const std::vector<std::string>& names, const std::vector<int>& indices) {
    std::vector<std::string> values;
    for (const int index : indices) values.push_back(blockName(names, index));
    return {std::move(name), std::move(values)};
}

VtkArray indices(std::string name, const std::vector<std::size_t>& rows) {
    std::vector<std::int32_t> values;
    for (const std::size_t row : rows) values.push_back(static_cast<std::int32_t>(row));
    return {std::move(name), std::move(values)};
}

Point turned(const Point& p, double angle) {
    return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

}  // namespace

VtkBlocks::VtkBlocks(const RunSource& run) : run_(run) {
    const SolvedBlocks solved = solvedBlocks(run.scene());
    for (const SolvedBlock& block : solved.blocks) {
        std::vector<Point>& corners = reference_.emplace_back();
        for (const Point& corner : counterClockwise(block.points)) corners.push_back(corner + solved.origin);
        pieces_.push_back(convexPieces(corners));
    }
    last_ = reference_;
}

void VtkBlocks::zero() {
    for (std::size_t i = 0; i < last_.size(); ++i)
        if (!last_[i].empty()) reference_[i] = last_[i];
}

/// Uses the block's rigid motion if the corners of the reference are not known.
Point VtkBlocks::displacementOf(const BlockState& block, std::size_t index, std::size_t corner) const {
    const Point& now = block.points[corner];
    if (reference_[index].size() == block.points.size()) return now - reference_[index][corner];
    const Point arm = now - block.centroid;
    return block.displacement + arm - turned(arm, -block.rotation);
}

VtkPolyData VtkBlocks::data(const Frame& frame) {
    const std::vector<Stage>& stages = run_.scene().stages;
    for (; stage_ < frame.stage; ++stage_)
        if (stages[stage_ + 1].zeroDisplacements) zero();
    VtkPolyData data;
    std::vector<double> moved;
    std::vector<std::size_t> rows;  // block of each cell
    for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
        const BlockState& block = frame.blocks[i];
        const auto first = static_cast<std::int64_t>(data.points.size());
        const bool known = reference_[i].size() == block.points.size();
        for (std::size_t corner = 0; corner < block.points.size(); ++corner) {
            const Point u = displacementOf(block, i, corner);
            data.points.push_back(block.points[corner]);
            moved.insert(moved.end(), {u.x(), u.y(), 0.0});
        }
        if (block.points.size() >= 3)
            for (const std::vector<int>& piece : known ? pieces_[i] : convexPieces(block.points)) {
                std::vector<std::int64_t> cell;
                for (const int corner : piece) cell.push_back(first + corner);
                data.polygons.add(cell);
                rows.push_back(i);
            }
        last_[i] = block.points;
    }
    const Rows table(Payload::Blocks, frame);
    data.pointData.push_back({"displacement_vector_m", std::move(moved), 3});
    data.cellData.push_back(indices("block", rows));
    data.cellData.push_back(namesOf("name", run_.blockNames(), {rows.begin(), rows.end()}));
    table.addAll(rows, {}, data.cellData);
    data.cellData.push_back(table.vector("displacement_vector_m", "ux", "uy", rows));
    data.cellData.push_back(table.vector("velocity_vector_m_per_s", "vx", "vy", rows));
    addDerived(blockQuantities(), frame.blocks, rows, data.cellData);
    return data;
}

namespace {

/// Columns that belong to the element that begins at a node, or to the face plate at the last node.
const std::vector<std::string_view> elementColumns{"axial_force", "shear_force", "ruptured"};

struct BoltCells {
    std::vector<std::size_t> rows;  // node at which each cell begins
    std::vector<std::int32_t> plates;  // 1 for a face plate
    std::vector<std::int32_t> elements;  // numbered from 0 at the far end; −1 for a face plate
};

/// Face plates come first, because VTK puts vertices before lines.
BoltCells addBoltCells(const Frame& frame, VtkPolyData& data) {
    BoltCells cells;
    const auto add = [&](VtkCells& kind, std::vector<std::int64_t> points, int element) {
        kind.add(points);
        cells.rows.push_back(static_cast<std::size_t>(points.front()));
        cells.plates.push_back(element < 0 ? 1 : 0);
        cells.elements.push_back(element);
    };
    std::int64_t first = 0;
    for (const BoltFrame& bolt : frame.bolts) {
        const auto nodes = static_cast<std::int64_t>(bolt.nodes.size());
        if (nodes > 0) add(data.vertices, {first + nodes - 1}, -1);
        first += nodes;
    }
    first = 0;
    for (const BoltFrame& bolt : frame.bolts) {
        const auto nodes = static_cast<std::int64_t>(bolt.nodes.size());
        for (std::int64_t node = 0; node + 1 < nodes; ++node)
            add(data.lines, {first + node, first + node + 1}, static_cast<int>(node));
        first += nodes;
    }
    return cells;
}

void addBoltState(const RunSource& run, const Frame& frame, const Rows& nodes, const BoltCells& cells,
                  std::vector<VtkArray>& arrays) {
    std::vector<std::string> names;
    std::vector<std::size_t> bolts;
    for (const std::size_t row : cells.rows) {
        bolts.push_back(static_cast<std::size_t>(nodes.value(row, nodes.columnOf("bolt"))));
        names.push_back(boltName(run.scene(), static_cast<int>(bolts.back())));
    }
    arrays.push_back(indices("bolt", bolts));
    arrays.push_back({"name", std::move(names)});
    arrays.push_back({"element", cells.elements});
    arrays.push_back({"plate", cells.plates});
    for (const std::string_view name : elementColumns)
        arrays.push_back(nodes.array(nodes.columnOf(name), cells.rows));
    Rows(Payload::Bolts, frame).addAll(bolts, {}, arrays);
}

}  // namespace

VtkPolyData vtkBolts(const RunSource& run, const Frame& frame) {
    VtkPolyData data;
    const Rows nodes(Payload::Nodes, frame);
    for (const BoltFrame& bolt : frame.bolts)
        for (const BoltNodeFrame& node : bolt.nodes) data.points.push_back(node.position);
    std::vector<std::int32_t> counted;
    for (const BoltFrame& bolt : frame.bolts)
        for (std::size_t node = 0; node < bolt.nodes.size(); ++node)
            counted.push_back(static_cast<std::int32_t>(node));
    data.pointData.push_back({"node", std::move(counted)});
    nodes.addAll(all(nodes.size()), elementColumns, data.pointData);
    addBoltState(run, frame, nodes, addBoltCells(frame, data), data.cellData);
    return data;
}

VtkPolyData vtkContacts(const RunSource& run, const Frame& frame) {
    VtkPolyData data;
    std::vector<int> a, b;
    for (const ContactFrame& contact : frame.contacts) {
        const auto index = static_cast<std::int64_t>(data.points.size());
        data.points.push_back(contact.position);
        data.vertices.add(std::vector<std::int64_t>{index});
        a.push_back(contact.blockA);
        b.push_back(contact.blockB);
    }
    data.pointData.push_back(namesOf("name_a", run.blockNames(), a));
    data.pointData.push_back(namesOf("name_b", run.blockNames(), b));
    const Rows contacts(Payload::Contacts, frame);
    contacts.addAll(all(contacts.size()), {"nx", "ny"}, data.pointData);  // added below, as they are not indices
    addDerived(contactQuantities(), frame.contacts, all(contacts.size()), data.pointData);
    data.pointData.push_back(contacts.vector("normal_vector", "nx", "ny", all(contacts.size())));
    std::vector<double> forces;
    for (const ContactFrame& contact : frame.contacts) {
        const Point force = forceOnA(contact);
        forces.insert(forces.end(), {force.x(), force.y(), 0.0});
    }
    data.pointData.push_back({"force_on_a_N", std::move(forces), 3});
    return data;
}

}  // namespace keyblock
