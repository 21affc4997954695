// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The design table as rows of CSV: one list of columns, each with its name and the cell
// that it writes.
#include "solver/results/bolt_design.h"
#include "solver/results/csv.h"
#include "solver/results/result_names.h"

namespace keyblock {

namespace {

struct DesignRow {
    const RunSource& run;
    const std::vector<Event>& events;
    const BoltDesign& design;

    const BoltExtremes& peaks() const { return design.use.extremes; }
    const Event* event() const { return design.since < 0 ? nullptr : &events[design.since]; }
};

struct DesignColumn {
    std::string_view name;
    void (*write)(const DesignRow& row, CsvWriter& csv);
};

void writeIfKnown(CsvWriter& csv, const std::optional<double>& value) {
    if (value) csv.number(*value);
    else csv.text("");
}

/// A number of a peak; empty if the bolt has carried no force.
void writeOf(CsvWriter& csv, const BoltPeak& peak, double value) {
    writeIfKnown(csv, peak.stage < 0 ? std::nullopt : std::optional(value));
}

void writeUse(const DesignRow& row, CsvWriter& csv, BoltStrength strength) {
    writeIfKnown(csv, row.design.use.use[static_cast<std::size_t>(strength)]);
}

std::string carriedNames(const DesignRow& row) {
    std::string names;
    for (const CarriedBlock& block : row.design.carries)
        names += (names.empty() ? "" : "|") + blockName(row.run.blockNames(), block.block);
    return names;
}

void writeSum(const DesignRow& row, CsvWriter& csv, double CarriedBlock::*member) {
    double sum = 0.0;
    for (const CarriedBlock& block : row.design.carries) sum += block.*member;
    writeIfKnown(csv, row.design.carries.empty() ? std::nullopt : std::optional(sum));
}

std::string eventBlockNames(const DesignRow& row) {
    const Event* event = row.event();
    if (!event) return {};
    const std::string block = blockName(row.run.blockNames(), event->block);
    return event->otherBlock < 0 ? block : block + "|" + blockName(row.run.blockNames(), event->otherBlock);
}

using OfDesign = const DesignRow&;

constexpr DesignColumn designCells[]{
    {"bolt", [](OfDesign r, CsvWriter& csv) { csv.text(boltName(r.run.scene(), r.design.use.bolt)); }},
    {"type", [](OfDesign r, CsvWriter& csv) { csv.text(r.run.scene().bolts[r.design.use.bolt].type); }},
    {"status", [](OfDesign r, CsvWriter& csv) { csv.text(wordOf(r.design.status)); }},
    {"peak_axial_force_N", [](OfDesign r, CsvWriter& csv) { csv.number(r.peaks().axialForce.value); }},
    {"peak_axial_at_m",
     [](OfDesign r, CsvWriter& csv) { writeOf(csv, r.peaks().axialForce, r.peaks().axialForce.at); }},
    {"peak_axial_stage",
     [](OfDesign r, CsvWriter& csv) { csv.text(stageName(r.run.scene(), r.peaks().axialForce.stage)); }},
    {"peak_axial_time_s",
     [](OfDesign r, CsvWriter& csv) { writeOf(csv, r.peaks().axialForce, r.peaks().axialForce.time); }},
    {"peak_shear_force_N", [](OfDesign r, CsvWriter& csv) { csv.number(r.peaks().shearForce.value); }},
    {"peak_shear_at_m",
     [](OfDesign r, CsvWriter& csv) { writeOf(csv, r.peaks().shearForce, r.peaks().shearForce.at); }},
    {"peak_moment_Nm", [](OfDesign r, CsvWriter& csv) { csv.number(r.peaks().moment.value); }},
    {"peak_moment_at_m", [](OfDesign r, CsvWriter& csv) { writeOf(csv, r.peaks().moment, r.peaks().moment.at); }},
    {"yield_force_N", [](OfDesign r, CsvWriter& csv) { writeIfKnown(csv, r.design.yieldForce); }},
    {"yield_use", [](OfDesign r, CsvWriter& csv) { writeIfKnown(csv, r.design.yieldUse); }},
    {"steel_use", [](OfDesign r, CsvWriter& csv) { writeUse(r, csv, BoltStrength::Steel); }},
    {"shear_use", [](OfDesign r, CsvWriter& csv) { writeUse(r, csv, BoltStrength::Shear); }},
    {"bond_use", [](OfDesign r, CsvWriter& csv) { writeUse(r, csv, BoltStrength::Bond); }},
    {"plate_use", [](OfDesign r, CsvWriter& csv) { writeUse(r, csv, BoltStrength::Plate); }},
    {"governs",
     [](OfDesign r, CsvWriter& csv) { csv.text(r.design.use.governs ? rowOf(*r.design.use.governs).key : ""); }},
    {"axial_force_N", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.now.axial); }},
    {"shear_force_N", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.now.shear); }},
    {"moment_Nm", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.now.moment); }},
    {"plate_normal_force_N", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.now.plateNormal); }},
    {"plate_shear_force_N", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.now.plateShear); }},
    {"bonded_length_m", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.bondedLength); }},
    {"debonded_length_m", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.debondedLength); }},
    {"debonded_share",
     [](OfDesign r, CsvWriter& csv) {
         const double whole = r.design.bondedLength;
         writeIfKnown(csv, whole > 0.0 ? std::optional(r.design.debondedLength / whole) : std::nullopt);
     }},
    {"elastic_J", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.state.elasticEnergy); }},
    {"plastic_J", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.state.plasticEnergy); }},
    {"bond_J", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.state.bondEnergy); }},
    {"energy_J", [](OfDesign r, CsvWriter& csv) { csv.number(r.design.energy()); }},
    {"carries", [](OfDesign r, CsvWriter& csv) { csv.text(carriedNames(r)); }},
    {"carried_weight_N", [](OfDesign r, CsvWriter& csv) { writeSum(r, csv, &CarriedBlock::weight); }},
    {"carrying_force_N", [](OfDesign r, CsvWriter& csv) { writeSum(r, csv, &CarriedBlock::force); }},
    {"since_event", [](OfDesign r, CsvWriter& csv) { csv.text(r.event() ? wordOf(r.event()->kind) : ""); }},
    {"since_bolt",
     [](OfDesign r, CsvWriter& csv) { csv.text(r.event() ? boltName(r.run.scene(), r.event()->bolt) : ""); }},
    {"since_block", [](OfDesign r, CsvWriter& csv) { csv.text(eventBlockNames(r)); }},
    {"since_stage",
     [](OfDesign r, CsvWriter& csv) { csv.text(r.event() ? stageName(r.run.scene(), r.event()->stage) : ""); }},
    {"since_time_s",
     [](OfDesign r, CsvWriter& csv) { writeIfKnown(csv, r.event() ? std::optional(r.event()->time) : std::nullopt); }},
};

}  // namespace

std::vector<std::string_view> designColumns() {
    std::vector<std::string_view> names;
    for (const DesignColumn& column : designCells) names.push_back(column.name);
    return names;
}

void writeDesignRows(const RunSource& run, std::size_t frame, std::optional<int> bolt, std::ostream& out) {
    const FrameHead& head = run.frames()[frame];
    const std::vector<Event> events = run.events();
    CsvWriter csv(out);
    for (const BoltDesign& design : boltDesigns(run, frame)) {
        if (bolt && design.use.bolt != *bolt) continue;
        csv.text(stageName(run.scene(), head.stage)).number(head.time);
        for (const DesignColumn& column : designCells) column.write({run, events, design}, csv);
        csv.endRow();
    }
}

}  // namespace keyblock
