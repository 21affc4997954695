// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One function per table. An index that does not apply gives an empty cell; an event
// between two blocks names both, separated by a bar.
#include "solver/results/tables.h"

#include "solver/results/block_forces.h"
#include "solver/results/bolt_design.h"
#include "solver/results/csv.h"
#include "solver/results/frame_quantities.h"
#include "solver/results/result_names.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 8> kindWords{"history",  "events", "bolts",  "blocks",
                                                    "contacts", "energy", "forces", "design"};

using Columns = std::vector<std::string_view>;

template <typename Row>
Columns withQuantities(Columns columns, std::span<const FrameQuantity<Row>> quantities) {
    for (const FrameQuantity<Row>& quantity : quantities)
        columns.push_back(quantity.column);
    return columns;
}

/// The columns after `stage,time_s`.
Columns columnsOf(TableKind kind, const HistoryColumns& history) {
    switch (kind) {
        case TableKind::Events:
            return {"step", "kind",          "bolt",          "node",           "element", "block",
                    "x_m",  "y_m",           "axial_force_N", "shear_force_N",  "anchor_force_N", "slip_m"};
        case TableKind::Bolts: {
            Columns columns = withQuantities({"bolt", "node", "s_m", "x_m", "y_m", "block", "anchor", "state"},
                                             boltQuantities());
            columns.insert(columns.end(), {"bond_strength_N", "bond_residual_N"});
            return columns;
        }
        case TableKind::Blocks: return withQuantities({"block", "x_m", "y_m"}, blockQuantities());
        case TableKind::Contacts:
            return withQuantities({"block_a", "block_b", "joint_material", "x_m", "y_m", "state"}, contactQuantities());
        case TableKind::Energy: return withQuantities({}, energyQuantities());
        case TableKind::Forces: return {"block", "source", "name", "x_m", "y_m", "fx_N", "fy_N", "moment_Nm"};
        case TableKind::Design: return designColumns();
        case TableKind::History: break;
    }
    return {history.names.begin(), history.names.begin() + history.monitorValues};
}

void writeHeader(const Columns& columns, CsvWriter& csv) {
    csv.text("stage").text("time_s");
    for (const std::string_view column : columns)
        csv.text(column);
    csv.endRow();
}

void beginRow(CsvWriter& csv, const Scene& scene, const RowMoment& moment) {
    csv.text(stageName(scene, moment.stage)).number(moment.time);
}

template <typename Row>
void addQuantities(CsvWriter& csv, const Row& row, std::span<const FrameQuantity<Row>> quantities) {
    for (const FrameQuantity<Row>& quantity : quantities)
        csv.number(quantity.value(row));
}

template <typename Row>
void endWithQuantities(CsvWriter& csv, const Row& row, std::span<const FrameQuantity<Row>> quantities) {
    addQuantities(csv, row, quantities);
    csv.endRow();
}

template <typename Timed>
std::vector<RowMoment> momentsOf(const std::vector<Timed>& rows) {
    std::vector<RowMoment> moments;
    for (const Timed& row : rows)
        moments.push_back({row.stage, row.time});
    return moments;
}

void writeHistory(const RunSource& run, const TableFilter& filter, CsvWriter& csv) {
    const std::size_t shown = run.columns().monitorValues;
    const std::vector<HistoryRow> rows = run.history();
    for (const std::size_t i : selected(momentsOf(rows), filter, When::All)) {
        beginRow(csv, run.scene(), {rows[i].stage, rows[i].time});
        for (std::size_t column = 0; column < shown; ++column)
            csv.number(rows[i].values[column]);
        csv.endRow();
    }
}

std::string eventBlocks(const std::vector<std::string>& blocks, const Event& event) {
    const std::string block = blockName(blocks, event.block);
    return event.otherBlock < 0 ? block : block + "|" + blockName(blocks, event.otherBlock);
}

void writeEvent(const RunSource& run, const Event& event, CsvWriter& csv) {
    const Scene& scene = run.scene();
    beginRow(csv, scene, {event.stage, event.time});
    csv.integer(event.step).text(wordOf(event.kind)).text(boltName(scene, event.bolt));
    csv.index(event.node).index(event.element).text(eventBlocks(run.blockNames(), event));
    csv.number(event.position.x()).number(event.position.y());
    csv.number(event.axialForce).number(event.shearForce).number(event.anchorForce).number(event.slip).endRow();
}

void writeEvents(const RunSource& run, const TableFilter& filter, CsvWriter& csv) {
    const std::vector<Event> events = run.events();
    for (const std::size_t i : selected(momentsOf(events), filter, When::All))
        if (!filter.bolt || events[i].bolt == *filter.bolt)
            writeEvent(run, events[i], csv);
}

void writeBoltRows(const RunSource& run, const Frame& frame, int bolt, CsvWriter& csv) {
    const Scene& scene = run.scene();
    int index = 0;
    for (const BoltNodeFrame& node : frame.bolts[bolt].nodes) {
        beginRow(csv, scene, {frame.stage, frame.time});
        csv.text(boltName(scene, bolt)).index(index++).number(node.s);
        csv.number(node.position.x()).number(node.position.y()).text(blockName(run.blockNames(), node.block));
        csv.text(anchorWord(node.real)).text(wordOf(node.state));
        addQuantities(csv, node, boltQuantities());
        if (node.bondStrength > 0.0) csv.number(node.bondStrength).number(node.bondResidual).endRow();
        else csv.text("").text("").endRow();
    }
}

void writeBolts(const RunSource& run, const Frame& frame, const TableFilter& filter, CsvWriter& csv) {
    for (int bolt = 0; bolt < static_cast<int>(frame.bolts.size()); ++bolt)
        if (!filter.bolt || bolt == *filter.bolt)
            writeBoltRows(run, frame, bolt, csv);
}

void writeBlocks(const RunSource& run, const Frame& frame, const TableFilter&, CsvWriter& csv) {
    for (int index = 0; index < static_cast<int>(frame.blocks.size()); ++index) {
        const BlockState& block = frame.blocks[index];
        if (block.area == 0.0) continue;  // not active
        beginRow(csv, run.scene(), {frame.stage, frame.time});
        csv.text(blockName(run.blockNames(), index)).number(block.centroid.x()).number(block.centroid.y());
        endWithQuantities(csv, block, blockQuantities());
    }
}

std::string jointMaterialName(const Scene& scene, int index) {
    if (index == intactJoint) return "intact";
    return index < 0 ? "" : scene.jointMaterials[index].first;
}

void writeContacts(const RunSource& run, const Frame& frame, const TableFilter&, CsvWriter& csv) {
    for (const ContactFrame& contact : frame.contacts) {
        beginRow(csv, run.scene(), {frame.stage, frame.time});
        csv.text(blockName(run.blockNames(), contact.blockA)).text(blockName(run.blockNames(), contact.blockB));
        csv.text(jointMaterialName(run.scene(), contact.jointMaterial));
        csv.number(contact.position.x()).number(contact.position.y()).text(wordOf(contact.state));
        endWithQuantities(csv, contact, contactQuantities());
    }
}

/// Name of the other block of a contact or bond, or of the bolt; loads, supports and walls have no names.
std::string nameOf(const RunSource& run, const BlockForce& force) {
    if (force.source == ForceSource::Bolt) return boltName(run.scene(), force.other);
    return blockName(run.blockNames(), force.other);
}

void writeForces(const RunSource& run, const Frame& frame, const TableFilter&, CsvWriter& csv) {
    for (const BlockForce& force : blockForces(frame)) {
        beginRow(csv, run.scene(), {frame.stage, frame.time});
        csv.text(blockName(run.blockNames(), force.block)).text(wordOf(force.source)).text(nameOf(run, force));
        csv.number(force.position.x()).number(force.position.y());
        for (const double value : {force.force.x(), force.force.y(), force.moment}) csv.number(value + 0.0);  // no -0
        csv.endRow();
    }
}

/// Writes the rows of the selected frames.
template <typename WriteFrame>
void writeFrames(const RunSource& run, const TableFilter& filter, CsvWriter& csv, WriteFrame writeFrame) {
    if (filter.when != When::All) {
        if (const auto index = frameAt(run, filter))
            writeFrame(run, run.frame(*index), filter, csv);
        return;
    }
    for (const std::size_t index : selected(momentsOf(run.frames()), filter, When::All))
        writeFrame(run, run.frame(index), filter, csv);
}

void writeDesign(const RunSource& run, const TableFilter& filter, std::ostream& out) {
    std::vector<std::size_t> frames;
    if (filter.when == When::All) frames = selected(momentsOf(run.frames()), filter, When::All);
    else if (const auto index = frameAt(run, filter)) frames = {*index};
    for (const std::size_t index : frames) writeDesignRows(run, index, filter.bolt, out);
}

void writeEnergy(const RunSource& run, const TableFilter& filter, CsvWriter& csv) {
    for (const std::size_t i : selected(momentsOf(run.frames()), filter, When::All)) {
        const FrameHead& frame = run.frames()[i];
        beginRow(csv, run.scene(), {frame.stage, frame.time});
        endWithQuantities(csv, frame.energy, energyQuantities());
    }
}

}  // namespace

std::span<const std::string_view> tableWords() { return kindWords; }

std::optional<TableKind> tableKindOf(std::string_view word) {
    const auto found = std::find(kindWords.begin(), kindWords.end(), word);
    if (found == kindWords.end())
        return std::nullopt;
    return static_cast<TableKind>(found - kindWords.begin());
}

bool hasBolts(TableKind kind) {
    return kind == TableKind::Bolts || kind == TableKind::Events || kind == TableKind::Design;
}

std::optional<std::size_t> frameAt(const RunSource& run, const TableFilter& filter) {
    const std::vector<std::size_t> indices = selected(momentsOf(run.frames()), filter, When::Last);
    if (indices.empty())
        return std::nullopt;
    const auto asked = std::find_if(indices.begin(), indices.end(), [&](std::size_t i) {
        return filter.events && run.frames()[i].events == *filter.events;
    });
    return asked != indices.end() ? *asked : indices.back();
}

void writeTable(TableKind kind, const RunSource& run, const TableFilter& filter, std::ostream& out) {
    CsvWriter csv(out);
    writeHeader(columnsOf(kind, run.columns()), csv);
    switch (kind) {
        case TableKind::History: return writeHistory(run, filter, csv);
        case TableKind::Events: return writeEvents(run, filter, csv);
        case TableKind::Energy: return writeEnergy(run, filter, csv);
        case TableKind::Bolts: return writeFrames(run, filter, csv, writeBolts);
        case TableKind::Blocks: return writeFrames(run, filter, csv, writeBlocks);
        case TableKind::Contacts: return writeFrames(run, filter, csv, writeContacts);
        case TableKind::Forces: return writeFrames(run, filter, csv, writeForces);
        case TableKind::Design: return writeDesign(run, filter, out);
    }
}

}  // namespace keyblock
