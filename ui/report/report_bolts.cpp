// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The design tables of the bolts, and the events with their causes.
#include "solver/results/event_groups.h"
#include "solver/results/result_names.h"
#include "ui/figure/figure.h"
#include "ui/picture/captions.h"
#include "ui/report/report_facts.h"
#include "ui/report/report_figures.h"

#include <algorithm>
#include <cmath>

namespace keyblock::report {

namespace {

constexpr std::size_t mostEvents = 60;  // rows of the table of events
constexpr double roundOff = 1e-9;  // of the axial force

std::string useOf(const BoltDesign& design, BoltStrength strength) {
    const auto& use = design.use.use[static_cast<std::size_t>(strength)];
    return use ? percentText(*use) : "–";
}

/// A peak in kilo-units; round-off compared with the axial force is shown as 0.
std::string peakIn(const BoltPeak& peak, const BoltPeak& axial, std::string_view unit) {
    if (peak.stage < 0) return "–";
    return std::abs(peak.value) < roundOff * std::abs(axial.value) ? "0" : inUnit(peak.value, unit);
}

ReportTable peakTable(const Facts& facts) {
    ReportTable table{"Peak forces of the bolts over the run and utilisation of their strengths in per cent",
                      {{"Bolt"},
                       {"Type"},
                       {"Status"},
                       {"Axial, kN", true},
                       {"at, m", true},
                       {"Stage"},
                       {"Shear, kN", true},
                       {"Moment, kN m", true},
                       {"Yield", true},
                       {"Steel", true},
                       {"Shear", true},
                       {"Bond", true},
                       {"Plate", true}},
                      {}};
    for (const BoltDesign& design : facts.designs) {
        const BoltExtremes& peaks = design.use.extremes;
        table.rows.push_back(
            {boltName(facts.scene(), design.use.bolt), facts.scene().bolts[design.use.bolt].type,
             std::string(wordOf(design.status)), peakIn(peaks.axialForce, peaks.axialForce, "kN"),
             peaks.axialForce.stage < 0 ? "–" : numeral(peaks.axialForce.at),
             stageName(facts.scene(), peaks.axialForce.stage), peakIn(peaks.shearForce, peaks.axialForce, "kN"),
             peakIn(peaks.moment, peaks.axialForce, "kN m"), design.yieldUse ? percentText(*design.yieldUse) : "–",
             useOf(design, BoltStrength::Steel), useOf(design, BoltStrength::Shear), useOf(design, BoltStrength::Bond),
             useOf(design, BoltStrength::Plate)});
    }
    return table;
}

std::string blocksOf(const Facts& facts, const Event& event) {
    return facts.block(event.block) + (event.otherBlock < 0 ? "" : " on " + facts.block(event.otherBlock));
}

/// "joint opening of b142 on b145", "debonding of roof.3 at node 4".
std::string eventText(const Facts& facts, const Event& event) {
    std::string text(rowOf(event.kind).title);
    if (event.bolt >= 0) text += " of " + boltName(facts.scene(), event.bolt);
    else if (event.block >= 0) text += " of " + blocksOf(facts, event);
    if (event.node >= 0) text += " at node " + std::to_string(event.node);
    if (event.element >= 0) text += " in element " + std::to_string(event.element);
    return text;
}

std::string momentText(const Facts& facts, const Event& event) {
    return stageName(facts.scene(), event.stage) + ", " + timeText(facts.scene(), event.stage, event.time);
}

std::string carriedText(const Facts& facts, const BoltDesign& design) {
    std::string text;
    for (const CarriedBlock& block : design.carries)
        text += (text.empty() ? "" : "; ") + facts.block(block.block) + " (" + inUnit(block.weight, "kN") + " kN)";
    return text.empty() ? "nothing" : text;
}

ReportTable loadTable(const Facts& facts) {
    ReportTable table{"The bolts at the end of the run: debonding, face plates, energy, and the rock that they carry",
                      {{"Bolt"},
                       {"Debonded, %", true},
                       {"Plate, kN", true},
                       {"Energy, J", true},
                       {"of it elastic, J", true},
                       {"Carries"},
                       {"with, kN", true},
                       {"since"}},
                      {}};
    for (const BoltDesign& design : facts.designs) {
        double force = 0.0;
        for (const CarriedBlock& block : design.carries) force += block.force;
        const Event* since = design.since < 0 ? nullptr : &facts.events[design.since];
        table.rows.push_back(
            {boltName(facts.scene(), design.use.bolt),
             design.bondedLength > 0.0 ? percentText(design.debondedLength / design.bondedLength) : "–",
             inUnit(design.now.plateNormal, "kN"), numeral(design.energy()), numeral(design.state.elasticEnergy),
             carriedText(facts, design), design.carries.empty() ? "–" : inUnit(force, "kN"),
             since ? eventText(facts, *since) + " (" + momentText(facts, *since) + ")" : "–"});
    }
    return table;
}

/// The events that are not minor, in order of time. If they are more than `most`, the most severe ones of them.
std::vector<std::size_t> listedEvents(const std::vector<Event>& events, std::size_t most) {
    std::vector<std::size_t> listed;
    for (std::size_t i = 0; i < events.size(); ++i)
        if (!isMinor(events[i].kind)) listed.push_back(i);
    if (listed.size() <= most) return listed;
    std::ranges::stable_sort(listed, std::ranges::greater{}, [&](std::size_t i) { return rowOf(events[i].kind).severity; });
    listed.resize(most);
    std::ranges::sort(listed);
    return listed;
}

std::string causeText(const Facts& facts, const Event& event) {
    if (event.cause < 0) return "load";
    const Event& cause = facts.events[event.cause];
    return eventText(facts, cause) + " (event " + std::to_string(event.cause + 1) + ")";
}

ReportTable eventTable(const Facts& facts) {
    ReportTable table{"Events of bolts and falls of blocks, with their causes",
                      {{"Event", true}, {"What"}, {"When"}, {"Axial, kN", true}, {"Shear, kN", true}, {"Caused by"}},
                      {}};
    for (const std::size_t i : listedEvents(facts.events, mostEvents)) {
        const Event& event = facts.events[i];
        const bool ofBolt = event.bolt >= 0;
        table.rows.push_back({std::to_string(i + 1), eventText(facts, event), momentText(facts, event),
                              ofBolt ? inUnit(event.axialForce, "kN") : "–",
                              ofBolt ? inUnit(event.shearForce, "kN") : "–", causeText(facts, event)});
    }
    const auto all = std::ranges::count_if(facts.events, [](const Event& event) { return !isMinor(event.kind); });
    if (all > static_cast<std::ptrdiff_t>(mostEvents))
        table.caption += "; the " + std::to_string(mostEvents) + " most severe of " + std::to_string(all);
    return table;
}

}  // namespace

void addBolts(const Facts& facts, ReportSection& section) {
    if (facts.scene().bolts.empty()) return addText(section, "The scene has no bolts.");
    if (facts.designs.empty()) return addText(section, "The run has no results of bolts yet.");
    addTable(section, peakTable(facts));
    addText(section,
            "Forces are per bolt; tension is positive, and positions are distances from the far end. Yield: axial "
            "force over the yield force. Steel: axial force and moment together over the strength. A dash marks a "
            "strength that the bolt does not have.");
    addTable(section, loadTable(facts));
    addText(section,
            "A bolt carries a block if its net force on the block against the weight is at least a tenth of that "
            "weight; weights, these forces and energies are for the thickness of the model. 'Since' is the first "
            "opening (or slip) of a joint of the block after the bolt was installed, or the event that caused it. "
            "Only a run without the bolt shows whether the block would fall: 'keyblock compare'.");
    const auto most = std::ranges::max_element(facts.designs, {}, [](const BoltDesign& d) { return d.use.highest(); });
    FigureRequest request;
    request.kind = FigureKind::Bolt;
    request.filter.bolt = most->use.bolt;
    addFigure(facts, request,
              "Bolt " + boltName(facts.scene(), most->use.bolt) +
                  ", the one with the highest utilisation, "
                  "at the end of the run",
              section);
}

void addEvents(const Facts& facts, ReportSection& section) {
    const std::string text = EventCounts(facts.events).text();
    addText(section, text.empty() ? "There were no events." : "Events of the run: " + text + ".");
    addTable(section, eventTable(facts));
    if (facts.stages.empty()) return;
    FigureRequest request;
    request.kind = FigureKind::Events;
    addFigure(facts, request, "Events of the run", section);
}

}  // namespace keyblock::report
