// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numerical settings with the errors that are known of the results, and the diagnostics
// of the solver in each stage.
#include "solver/results/quantity.h"
#include "solver/results/result_names.h"
#include "solver/scene/automatic.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/preset.h"
#include "ui/report/report_facts.h"

#include <algorithm>
#include <cmath>

namespace keyblock::report {

namespace {

bool isDynamic(const Stage& stage) { return stage.kind == StageKind::Dynamic; }

std::string timeStepsText(const Scene& scene) {
    std::string text;
    for (const Stage& stage : scene.stages)
        if (isDynamic(stage))
            text += (text.empty() ? "" : ", ") + stage.name + " " +
                    numeral(1e3 * stage.timeStep.value_or(automaticTimeStep(scene, stage))) + " ms";
    return text;
}

ReportTable settingsTable(const Scene& scene) {
    const Analysis& analysis = scene.analysis;
    const Numerics numerics = numericsOf(analysis);
    ReportTable table{"Numerical settings", {{"Setting"}, {"Value"}}, {}};
    const auto add = [&table](const char* setting, const std::string& value) {
        table.rows.push_back({setting, value});
    };
    add("Preset", presetText(analysis));
    if (std::ranges::any_of(scene.stages, isDynamic)) {
        add("Time integration", std::string(integrationLabels[static_cast<std::size_t>(analysis.integration)]));
        add("Longest time steps", timeStepsText(scene));
    }
    add("Iteration", std::string(iterationLabels[static_cast<std::size_t>(analysis.iteration)]));
    add("Contacts", std::string(contactMethodLabels[static_cast<std::size_t>(numerics.contact)]));
    add("Contact stiffness over Young's modulus and thickness", numeral(numerics.penaltyRatio));
    add("Tolerance of the unbalanced force", numeral(numerics.tolerance));
    add("Max. iterations of a step", std::to_string(numerics.maxPasses));
    add("Unbalanced force at which blocks sleep, over their weight", numeral(numerics.sleepTolerance));
    return table;
}

std::string valueText(const Measurement& measured) { return measured.value ? numeral(*measured.value) : "–"; }

/// Values that the scene expects, from closed forms or experiments, with the deviations of the run.
ReportTable expectedTable(const RecordedRun& run) {
    ReportTable table{
        "Computed values and those that the scene expects, in SI units",
        {{"Quantity"}, {"Computed", true}, {"Expected", true}, {"Deviation", true}, {"Tolerance", true}, {"Source"}},
        {}};
    for (const Expected& expected : run.scene.about.expected) {
        const MeasuredComparison found = compare(expected, run);
        const bool relative = expected.value != 0.0, known = found.measured.value.has_value();
        table.rows.push_back({expected.quantity, valueText(found.measured), numeral(expected.value),
                              !known     ? "–"
                              : relative ? percentText(found.deviation) + " %"
                                         : numeral(found.deviation),
                              relative ? percentText(expected.tolerance) + " %" : numeral(expected.tolerance),
                              known ? expected.source : found.measured.problem});
    }
    return table;
}

ReportTable quantityTable(const RecordedRun& run) {
    ReportTable table{"Quantities of the scene, in SI units", {{"Quantity"}, {"Value", true}, {"Remark"}}, {}};
    for (const std::string& text : run.scene.quantities) {
        const Measurement measured = measure(text, run);
        table.rows.push_back(
            {text, valueText(measured), measured.order.empty() ? measured.problem : orderText(measured.order, 6)});
    }
    return table;
}

/// Errors that runs with finer settings estimate. Of an order of events, the error is the share that differs.
ReportTable estimateTable(const ErrorEstimate& estimate) {
    ReportTable table{"Estimated errors of the quantities, in SI units",
                      {{"Quantity"}, {"Value", true}, {"Error", true}, {"Share, %", true}, {"Remark"}},
                      {}};
    for (const QuantityEstimate& one : estimate.quantities) {
        const bool known = one.remark.empty() && one.error, isOrder = known && !one.value;
        const std::optional<double> share = !known              ? std::nullopt
                                            : isOrder           ? one.error
                                            : *one.value != 0.0 ? std::optional(*one.error / std::abs(*one.value))
                                                                : std::nullopt;
        table.rows.push_back({one.quantity, one.value ? numeral(*one.value) : "–",
                              known && !isOrder ? "± " + numeral(*one.error) : "–", share ? numeral(100.0 * *share) : "–",
                              isOrder ? "of the order differs" : one.remark});
    }
    return table;
}

/// Adds the estimate of errors, or says how to make one.
void addEstimate(const std::optional<ErrorEstimate>& estimate, ReportSection& section) {
    if (!estimate)
        return addText(section,
                       "The errors of the discretisation and of the settings were not estimated; 'keyblock run "
                       "--estimate-error' estimates them, 'keyblock trade' measures them.");
    addTable(section, estimateTable(*estimate));
    std::string runs;
    for (const std::string& text : estimate->refinements) runs += (runs.empty() ? "" : "; ") + text;
    if (!runs.empty()) addText(section, "The errors are estimated from runs with: " + runs + ".");
}

/// "b12: 0.0001": block and unbalanced force over its weight.
std::string worstText(const Facts& facts, const WorstBalance& worst) {
    return worst.block < 0 ? "–" : facts.block(worst.block) + ": " + numeral(worst.share);
}

}  // namespace

void addNumerics(const Facts& facts, ReportSection& section) {
    const std::vector<HistoryRow> history = facts.run.history();
    const RecordedRun recorded{facts.scene(), history, facts.events, facts.stages};
    addTable(section, settingsTable(facts.scene()));
    addTable(section, quantityTable(recorded));
    addTable(section, expectedTable(recorded));
    double residual = 0.0, balance = 0.0, penetration = 0.0;
    for (const StageRecord& record : facts.stages) {
        if (!record.ended) continue;
        residual = std::max(residual, record.result.health.maxResidual);
        balance = std::max(balance, std::abs(record.result.health.balanceError));
        penetration = std::max(penetration, record.result.health.maxPenetrationRatio);
    }
    addText(section, "Measured in this run: an unbalanced force of at most " + numeral(residual) +
                         " of the acting forces, an energy balance error of at most " + numeral(balance) +
                         " of its largest term, and a penetration of at most " + numeral(penetration) +
                         " of the size of a block.");
    addEstimate(facts.request.estimate, section);
}

void addDiagnostics(const Facts& facts, ReportSection& section) {
    ReportTable table{"Solver diagnostics of each stage",
                      {{"Stage"},
                       {"Steps", true},
                       {"Iterations per step", true},
                       {"Step reductions", true},
                       {"Reductions for energy", true},
                       {"Largest penetration", true},
                       {"Largest residual", true},
                       {"Energy balance error", true},
                       {"Largest unbalanced share of weight"}},
                      {}};
    for (const StageRecord& record : facts.stages) {
        if (!record.ended) continue;
        const Health& health = record.result.health;
        const auto steps = static_cast<double>(std::max(1L, record.result.steps));
        table.rows.push_back({stageName(facts.scene(), record.result.stage), std::to_string(record.result.steps),
                              numeral(static_cast<double>(health.passes) / steps), std::to_string(health.stepCuts),
                              std::to_string(health.energyCuts), numeral(health.maxPenetrationRatio),
                              numeral(health.maxResidual), numeral(health.balanceError),
                              worstText(facts, health.worst)});
    }
    addTable(section, std::move(table));
    addText(section,
            "Penetration is relative to the size of the smaller block, the residual to the acting forces, and the "
            "energy balance error to the largest term of the balance.");
    const std::vector<StageWarning> warnings = stageWarnings(facts.run);
    for (const StageWarning& warning : warnings)
        addText(section, "Warning: " + warning.text + ".", ReportTextKind::Warning);
    if (warnings.empty())
        addText(section,
                "No block exceeds the unbalanced force that its stage allows, and no energy balance error "
                "exceeds 1 %.");
}

}  // namespace keyblock::report
