// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/error_estimate.h"

#include "solver/results/quantity.h"
#include "solver/scene/automatic.h"
#include "solver/scene/bond_per_node.h"
#include "solver/scene/lookup.h"
#include "solver/scene/preset.h"
#include "solver/trade/trade_errors.h"
#include "solver/trade/trade_point.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double ofFirstOrder = 2.0, ofSecondOrder = 4.0 / 3.0;  // error over the change when a size is halved

std::optional<Refinement> finerSteps(const Scene& scene) {
    Refinement finer{"", scene, ofFirstOrder};
    bool steps = false, increments = false;
    for (Stage& stage : finer.scene.stages) {
        if (stage.kind == StageKind::Dynamic) {
            stage.timeStep = 0.5 * stage.timeStep.value_or(automaticTimeStep(scene, stage));
            steps = true;
        } else if (stage.increments) {
            stage.increments = 2 * *stage.increments;
            increments = true;
        }
    }
    if (!steps && !increments) return std::nullopt;
    finer.text = steps ? "half the time step" : "";
    if (increments) finer.text += std::string(steps ? " and " : "") + "twice the increments";
    return finer;
}

/// \param solved the scene after cutting, to which `bolt` refers.
std::optional<Refinement> finerBolt(const Scene& scene, const Scene& solved, int bolt) {
    const Bolt& most = solved.bolts[bolt];
    if (isGivenPerNode(anchorsOf(solved, most))) return std::nullopt;
    Refinement finer{"", scene, ofSecondOrder};
    if (!most.divisions) {
        finer.scene.analysis.divisionsFactor = 2.0 * numericsOf(scene.analysis).divisionsFactor;
        finer.text = "twice the divisions of bolts with automatic divisions";
        return finer;
    }
    const auto own = std::find_if(finer.scene.bolts.begin(), finer.scene.bolts.end(),
                                  [&](const Bolt& other) { return other.name == most.name; });
    if (own != finer.scene.bolts.end()) {
        own->divisions = 2 * *most.divisions;
        finer.text = "twice the divisions of bolt " + most.name;
        return finer;
    }
    const std::string pattern = most.name.substr(0, most.name.rfind('.'));
    for (ScenePattern& other : finer.scene.boltPatterns)
        if (other.name == pattern) other.divisions = 2 * *most.divisions;
    finer.text = "twice the divisions of pattern " + pattern;
    return finer;
}

/// Adds the change by a refinement to an estimate.
void addChange(const Measurement& base, const Measurement& fine, const Refinement& refinement, QuantityEstimate& to) {
    if (!to.remark.empty()) return;
    TradePoint a, b;
    a.values = {fine};
    b.values = {base};
    const std::optional<double> change = errorOf(a, b, {to.quantity}, 0);
    if (!change) {
        to.error.reset();
        to.remark = "only one of this run and that with " + refinement.text + " has a value";
        return;
    }
    const bool relative = base.order.empty() && fine.order.empty() && base.value && *base.value != 0.0;
    const double size = relative ? *change * std::abs(*base.value) : *change;
    const bool whole = isCounted(to.quantity) || !base.order.empty() || !fine.order.empty();
    to.error = to.error.value_or(0.0) + (whole ? 1.0 : refinement.factor) * size;
}

QuantityEstimate startOf(const std::string& quantity, const Measurement& base, bool refined) {
    QuantityEstimate estimate{quantity, base.value, std::nullopt, base.problem};
    if (!base.problem.empty()) return estimate;
    if (quantity == "energy_error") estimate.remark = "an error itself";
    else if (!refined) estimate.remark = "the scene has no settings to refine";
    return estimate;
}

}  // namespace

std::vector<Refinement> refinementsOf(const Scene& scene, const Results& results) {
    std::vector<Refinement> all;
    if (std::optional<Refinement> finer = finerSteps(scene)) all.push_back(std::move(*finer));
    if (const int bolt = mostLoadedBolt(results); bolt >= 0)
        if (std::optional<Refinement> finer = finerBolt(scene, cutScene(scene).scene, bolt))
            all.push_back(std::move(*finer));
    return all;
}

std::optional<ErrorEstimate> estimateErrors(const Scene& scene, const Results& results, const EstimateRun& run) {
    const SceneCut cut = cutScene(scene);
    std::vector<std::string> names = scene.quantities.empty() ? proposedQuantities(cut.scene, results)
                                                              : scene.quantities;
    const std::vector<Refinement> refinements = refinementsOf(scene, results);
    std::vector<Measurement> base;
    ErrorEstimate estimate;
    for (const std::string& name : names) {
        base.push_back(measure(name, cut.scene, results));
        estimate.quantities.push_back(startOf(name, base.back(), !refinements.empty()));
    }
    for (const Refinement& refinement : refinements) {
        const TradeSetting setting{"refined", refinement.text, {}, [&](Scene& changed) { changed = refinement.scene; }};
        const TradeRun runFine = [&](const Scene& fine, const SceneCut& fineCut, int, Sink& sink) {
            run(fine, fineCut, refinement.text, sink);
        };
        const std::optional<TradePoint> point = measurePoint(scene, setting, names, runFine);
        if (!point) return std::nullopt;
        estimate.refinements.push_back(refinement.text);
        for (std::size_t q = 0; q < names.size(); ++q) {
            if (!point->failure.empty() && estimate.quantities[q].remark.empty())
                estimate.quantities[q].remark = "the run with " + refinement.text + " has no result: " + point->failure;
            addChange(base[q], point->values[q], refinement, estimate.quantities[q]);
        }
    }
    return estimate;
}

}  // namespace keyblock
