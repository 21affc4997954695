// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Side by side: the tables of the unified bolt paper, the independent reference
// and this program. The program is checked against the reference, because no
// interpretation of the paper's parameters reproduces all of its numbers. No
// parameter is adjusted to fit them.
#include "solver/verify/paper_steel.h"
#include "solver/verify/readings.h"
#include "solver/verify/references.h"
#include "solver/verify/scenes.h"
#include "solver/verify/verify.h"

#include <cmath>

namespace keyblock {

namespace {

constexpr double ofLoads = 5e-3, ofOpenings = 1e-2;

PaperRow row(const char* quantity, const char* unit, std::optional<double> paper, std::optional<double> reference,
             double keyblock, double tolerance) {
    const bool passed = !reference || std::abs(keyblock - *reference) <= tolerance * std::abs(*reference);
    return {quantity, unit, paper, reference, keyblock, tolerance, passed};
}

/// Rows are in kN and mm, as printed in the paper.
PaperRow load(const char* quantity, std::optional<double> paper, double reference, double keyblock) {
    return row(quantity, "kN", paper, reference * 1e-3, keyblock * 1e-3, ofLoads);
}

PaperRow opening(const char* quantity, std::optional<double> paper, double reference, double keyblock) {
    return row(quantity, "mm", paper, reference * 1e3, keyblock * 1e3, ofOpenings);
}

PaperTable rebarTable(const RebarReference& r) {
    const Solved solved =
        solve(paperRebar(r.youngsModulus, r.peak, r.divisions, rigidRock, r.lastOpening + 0.2e-3, 50));
    const std::vector<Release> found = releases(solved);
    const Release none{EventKind::Debonding, -1, NAN, NAN};
    const Release first = found.empty() ? none : found.front(), last = found.empty() ? none : found.back();
    Release largest = none;
    for (const Release& release : found)
        if (!(release.load <= largest.load)) largest = release;
    PaperTable table;
    table.title = std::string("Rebar across an opening joint, ") + r.title +
                  (r.divisions == 59 ? ", 60 nodes" : ", 61 nodes (one on the joint)");
    const std::vector<int> order = rebarOrder(r.divisions, r.releases);
    table.rows = {
        load("first debonding", 121.96, r.firstLoad, first.load),
        opening("first debonding", 0.05875, r.firstOpening, first.opening),
        load("largest load", 164.58, r.largestLoad, reading(solved, "max joint force")),
        opening("largest load", 0.3345, r.largestOpening, largest.opening),
        opening("last drop", 0.345, r.lastOpening, last.opening),
        load("residual", 67.20, rebarResidual, reading(solved, "last joint force")),
        row("debonded nodes", "", std::nullopt, r.releases, static_cast<double>(found.size()), 0.0),
        row("nodes in the reference's order", "", std::nullopt, r.releases, agreeing(found, order), 0.0),
    };
    return table;
}

PaperTable dBoltTable(const DBoltReference& r) {
    const Solved solved = solve(paperDBolt(r.tableSteel ? tableSteel : textSteel,
                                           r.plate ? PlateKind::Spring : PlateKind::None, rigidRock,
                                           r.ruptureOpening + 5e-3, 200));
    const auto path = loadPath(solved);
    PaperTable table;
    table.title = std::string("D-bolt across an opening joint, ") + r.title;
    table.rows = {
        load("first yield", 172.24, r.yieldLoad, reading(solved, "first yield joint force")),
        opening("first yield", 4.93, r.yieldOpening, reading(solved, "first yield opening")),
        load("at 50 mm", 200.0, r.loadAt50, loadAtOpening(path, 0.05)),
        load("at 100 mm", 200.0, r.loadAt100, loadAtOpening(path, 0.1)),
        opening("rupture", 154.48, r.ruptureOpening, reading(solved, "first tensile-rupture opening")),
        load("rupture", std::nullopt, r.ruptureLoad, reading(solved, "first tensile-rupture joint force")),
    };
    return table;
}

PaperTable elasticTable(const ElasticRebarReference& r) {
    const Solved solved = solve(elasticRebar(r.stiffness, rigidRock));
    PaperTable table;
    const double stiffness = r.stiffness * 1e-6;
    const std::string number = stiffness == 84.78 ? "84.78" : std::to_string(static_cast<int>(stiffness));
    table.title = "Elastic rebar under 200 kN, " + number + " kN/mm per node";
    table.rows = {
        opening("opening", std::nullopt, r.opening, reading(solved, "last opening")),
        load("plate", std::nullopt, r.plate, reading(solved, "last B.plate_force")),
        load("largest anchor force", std::nullopt, r.largestAnchor, std::abs(reading(solved, "last B.anchor_force"))),
        load("axial force in element 20", std::nullopt, r.force20, reading(solved, "last force at 0.683 m")),
    };
    return table;
}

}  // namespace

std::vector<PaperTable> paperTables() {
    std::vector<PaperTable> tables;
    for (const RebarReference& r : rebarReferences) tables.push_back(rebarTable(r));
    for (const DBoltReference& r : dBoltReferences) tables.push_back(dBoltTable(r));
    for (const ElasticRebarReference& r : elasticRebarReferences) tables.push_back(elasticTable(r));
    return tables;
}

}  // namespace keyblock
