// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/trade_axes.h"

#include "solver/scene/automatic.h"
#include "solver/scene/bond_per_node.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/preset.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

constexpr std::array divisions{15, 30, 60, 120, 240};
constexpr std::array finerAutomatic{2.0, 4.0};  // times the fineness of the scene's own automatic divisions
// times the scene's own; half the finest of a preset, so that the error of that one is not taken for zero
constexpr std::array timeSteps{4.0, 2.0, 0.5, 0.25, 0.125};
constexpr std::array increments{5, 20, 80};
constexpr std::array tolerances{1e-3, 1e-4, 1e-5, 1e-6};
// times the scene's own; three times the stiffest of a preset, for the same reason
constexpr std::array penalties{0.1, 0.31622776601683794, 3.1622776601683794, 10.0, 31.622776601683793};
constexpr std::array cellSizes{2.0, 0.5};  // times the scene's own
constexpr std::array sleepTolerances{1e-2, 1e-3, 0.0};
constexpr int usualIncrements = 40;  // of automatic ones, for the estimate of the cost
constexpr double costPerDecade = 1.25;  // of the tolerance
constexpr double costOfStiffContacts = 1.3, costOfMultipliers = 3.0, costOfAwake = 5.0, costOfOpenClose = 2.0;
constexpr std::size_t mostOpenClose = 60;  // blocks of a scene on which the open–close iteration is tried

bool hasStage(const Scene& scene, StageKind kind) {
    return std::any_of(scene.stages.begin(), scene.stages.end(),
                       [&](const Stage& stage) { return stage.kind == kind; });
}

std::string at(const char* list, std::size_t i, const char* key, const std::string& value) {
    return std::string(list) + "[" + std::to_string(i) + "]." + key + "=" + value;
}

TradeSetting analysisSetting(const std::string& axis, const std::string& value, std::function<void(Analysis&)> change) {
    TradeSetting setting{axis, value, {"analysis." + axis + "=" + value}, {}};
    setting.apply = [change = std::move(change)](Scene& scene) { change(scene.analysis); };
    return setting;
}

template <typename Choice>
std::string word(Choice choice) {
    return std::string(wordsOf(choice)[static_cast<std::size_t>(choice)]);
}

/// Whether a bolt may have other divisions without being another bolt.
bool isDivided(const Scene& scene, const std::string& type, const std::optional<std::vector<Anchor>>& own) {
    const BoltType* found = findBoltType(scene, type);
    return !(own ? isGivenPerNode(*own) : found && isGivenPerNode(found->anchors));
}

bool isDivided(const Scene& scene, const Bolt& bolt) { return isDivided(scene, bolt.type, bolt.anchors); }
bool isDivided(const Scene& scene, const ScenePattern& bolts) { return isDivided(scene, bolts.type, std::nullopt); }

bool hasDividedBolts(const Scene& scene) {
    const auto divided = [&](const auto& bolt) { return isDivided(scene, bolt); };
    return std::any_of(scene.bolts.begin(), scene.bolts.end(), divided) ||
           std::any_of(scene.boltPatterns.begin(), scene.boltPatterns.end(), divided);
}

/// Whether all bolts that may be divided have automatic divisions.
bool isAutomatic(const Scene& scene) {
    const auto automatic = [&](const auto& bolt) { return !isDivided(scene, bolt) || !bolt.divisions; };
    return std::all_of(scene.bolts.begin(), scene.bolts.end(), automatic) &&
           std::all_of(scene.boltPatterns.begin(), scene.boltPatterns.end(), automatic);
}

/// Automatic divisions that are finer everywhere. Equal ones are coarser at joints than automatic ones, however many
/// there are within reason, so that results do not converge to theirs.
void addFinerAutomatic(const Scene& scene, const TradeModel& model, TradeAxis& axis) {
    for (const double factor : finerAutomatic) {
        const double value = factor * numericsOf(scene.analysis).divisionsFactor;
        TradeSetting setting{axis.name,
                             "automatic × " + rounded(factor),
                             {"analysis.divisions_factor=" + shortest(value)},
                             {},
                             1.0 / factor};
        setting.apply = [value](Scene& changed) { changed.analysis.divisionsFactor = value; };
        const double own = model.blockUnknowns + model.boltUnknowns;
        setting.cost = own > 0.0 ? (model.blockUnknowns + factor * model.boltUnknowns) / own : 1.0;
        axis.settings.push_back(std::move(setting));
    }
}

/// Bolts whose bond is given per node keep their divisions, on which their strength depends.
TradeAxis divisionsAxis(const Scene& scene, const TradeModel& model) {
    TradeAxis axis{"divisions", {}, 0.0, true};
    for (const int n : divisions) {
        TradeSetting setting{axis.name, std::to_string(n), {}, {}, 1.0 / n};
        for (std::size_t i = 0; i < scene.bolts.size(); ++i)
            if (isDivided(scene, scene.bolts[i]))
                setting.overrides.push_back(at("bolts", i, "divisions", setting.text));
        for (std::size_t i = 0; i < scene.boltPatterns.size(); ++i)
            if (isDivided(scene, scene.boltPatterns[i]))
                setting.overrides.push_back(at("bolt_patterns", i, "divisions", setting.text));
        setting.apply = [n](Scene& changed) {
            for (Bolt& bolt : changed.bolts)
                if (isDivided(changed, bolt)) bolt.divisions = n;
            for (ScenePattern& pattern : changed.boltPatterns)
                if (isDivided(changed, pattern)) pattern.divisions = n;
        };
        const double own = model.blockUnknowns + model.boltUnknowns;
        setting.cost = own > 0.0 ? (model.blockUnknowns + 3.0 * model.bolts * (n + 1)) / own : 1.0;
        axis.settings.push_back(std::move(setting));
    }
    if (isAutomatic(scene)) {
        for (TradeSetting& equal : axis.settings) equal.size = 0.0;  // of another series, see addFinerAutomatic
        axis.ownSize = 1.0;
        addFinerAutomatic(scene, model, axis);
    }
    return axis;
}

/// All dynamic stages have their steps changed by the same factor.
TradeAxis timeStepAxis(const Scene& scene) {
    TradeAxis axis{"time_step", {}, 1.0, true};
    for (const double factor : timeSteps) {
        TradeSetting setting{axis.name, "× " + rounded(factor), {}, {}, factor, 1.0 / factor};
        for (std::size_t i = 0; i < scene.stages.size(); ++i) {
            const Stage& stage = scene.stages[i];
            if (stage.kind != StageKind::Dynamic) continue;
            const double step = factor * stage.timeStep.value_or(automaticTimeStep(scene, stage));
            setting.overrides.push_back(at("stages", i, "time_step", shortest(std::min(step, stage.duration))));
        }
        setting.apply = [factor](Scene& changed) {
            for (Stage& stage : changed.stages)
                if (stage.kind == StageKind::Dynamic)
                    stage.timeStep = std::min(factor * stage.timeStep.value_or(automaticTimeStep(changed, stage)),
                                              stage.duration);
        };
        axis.settings.push_back(std::move(setting));
    }
    return axis;
}

/// Number of increments that all static stages give; none if they are automatic or differ.
std::optional<int> givenIncrements(const Scene& scene) {
    std::optional<int> given;
    for (const Stage& stage : scene.stages) {
        if (stage.kind != StageKind::Static) continue;
        if (!stage.increments || (given && *given != *stage.increments)) return std::nullopt;
        given = stage.increments;
    }
    return given;
}

TradeAxis incrementsAxis(const Scene& scene) {
    const std::optional<int> own = givenIncrements(scene);
    TradeAxis axis{"increments", {}, own ? 1.0 / *own : 0.0, true};
    for (const int n : increments) {
        if (n == own) continue;
        TradeSetting setting{axis.name, std::to_string(n), {},
                             {},        1.0 / n,           n / static_cast<double>(own.value_or(usualIncrements))};
        for (std::size_t i = 0; i < scene.stages.size(); ++i)
            if (scene.stages[i].kind == StageKind::Static)
                setting.overrides.push_back(at("stages", i, "increments", setting.text));
        setting.apply = [n](Scene& changed) {
            for (Stage& stage : changed.stages)
                if (stage.kind == StageKind::Static) stage.increments = n;
        };
        axis.settings.push_back(std::move(setting));
    }
    return axis;
}

TradeAxis toleranceAxis(const Scene& scene) {
    const double own = numericsOf(scene.analysis).tolerance;
    TradeAxis axis{"tolerance", {}, own, true};
    for (const double value : tolerances) {
        if (value == own) continue;
        TradeSetting setting = analysisSetting(axis.name, shortest(value),
                                               [value](Analysis& a) { a.tolerance = value; });
        setting.size = value;
        setting.cost = std::pow(costPerDecade, std::log10(own / value));
        axis.settings.push_back(std::move(setting));
    }
    return axis;
}

TradeAxis penaltyAxis(const Scene& scene) {
    const double own = numericsOf(scene.analysis).penaltyRatio;
    TradeAxis axis{"penalty_ratio", {}, 1.0, true};
    for (const double factor : penalties) {
        const double value = factor * own;
        TradeSetting setting = analysisSetting(axis.name, shortest(value),
                                               [value](Analysis& a) { a.penaltyRatio = value; });
        setting.text = rounded(value);
        setting.size = 1.0 / factor;
        setting.cost = factor > 1.0 ? costOfStiffContacts : 1.0;
        axis.settings.push_back(std::move(setting));
    }
    return axis;
}

TradeAxis contactAxis(const Scene& scene) {
    TradeAxis axis{"contact", {}, 0.0, false};
    for (const ContactMethod method : {ContactMethod::Penalty, ContactMethod::AugmentedLagrangian}) {
        if (method == numericsOf(scene.analysis).contact) continue;
        axis.settings.push_back(
            analysisSetting(axis.name, word(method), [method](Analysis& a) { a.contact = method; }));
        if (method == ContactMethod::AugmentedLagrangian) axis.settings.back().cost = costOfMultipliers;
    }
    return axis;
}

TradeAxis cellsAxis(const Scene& scene) {
    TradeAxis axis{"sub_blocks", {}, 1.0, true};
    for (const double factor : cellSizes) {
        TradeSetting setting{axis.name, "× " + rounded(factor), {}, {}, factor, std::pow(factor, -2.5)};
        for (std::size_t i = 0; i < scene.blocks.size(); ++i)
            if (scene.blocks[i].subBlocks)
                setting.overrides.push_back(
                    at("blocks", i, "sub_blocks.size", shortest(factor * scene.blocks[i].subBlocks->size)));
        setting.apply = [factor](Scene& changed) {
            for (Block& block : changed.blocks)
                if (block.subBlocks) block.subBlocks->size *= factor;
        };
        axis.settings.push_back(std::move(setting));
    }
    return axis;
}

/// The classical iteration is for small scenes.
TradeAxis iterationAxis(const Scene& scene) {
    TradeAxis axis{"iteration", {}, 0.0, false};
    for (const Iteration method : {Iteration::Convex, Iteration::OpenClose}) {
        if (method == scene.analysis.iteration) continue;
        axis.settings.push_back(
            analysisSetting(axis.name, word(method), [method](Analysis& a) { a.iteration = method; }));
        if (method == Iteration::OpenClose) axis.settings.back().cost = costOfOpenClose;
    }
    return axis;
}

TradeAxis presetAxis(const Scene& scene) {
    TradeAxis axis{presetAxisName, {}, 0.0, false};
    const double own = numericsOf(scene.analysis).timeStepFactor;
    for (const Preset preset : {Preset::Sketch, Preset::Draft, Preset::Engineering, Preset::Reference}) {
        if (preset == scene.analysis.preset) continue;
        axis.settings.push_back(analysisSetting(axis.name, word(preset), [preset](Analysis& a) { a.preset = preset; }));
        Analysis changed = scene.analysis;
        changed.preset = preset;
        axis.settings.back().cost = own / numericsOf(changed).timeStepFactor;
    }
    return axis;
}

/// Calls `change` for every list of anchors.
template <typename Change>
void forAnchors(Scene& scene, const Change& change) {
    for (BoltType& type : scene.boltTypes) change(type.anchors);
    for (Bolt& bolt : scene.bolts)
        if (bolt.anchors) change(*bolt.anchors);
}

/// Softening bonds made brittle.
TradeAxis bondAxis(const Scene& scene) {
    TradeAxis axis{bondAxisName, {}, 0.0, false};
    bool softens = false;
    Scene bolts;
    bolts.boltTypes = scene.boltTypes;
    bolts.bolts = scene.bolts;
    forAnchors(bolts, [&](const std::vector<Anchor>& anchors) {
        for (const Anchor& anchor : anchors) softens = softens || anchor.softeningSlip > 0.0;
    });
    if (!softens) return axis;
    TradeSetting setting{axis.name, "brittle", {}, {}};
    setting.apply = [](Scene& changed) {
        forAnchors(changed, [](std::vector<Anchor>& anchors) {
            for (Anchor& anchor : anchors) anchor.softeningSlip = 0.0;
        });
    };
    axis.settings.push_back(std::move(setting));
    return axis;
}

/// Only if no dynamic stage chooses a scheme of its own.
TradeAxis integrationAxis(const Scene& scene) {
    TradeAxis axis{"integration", {}, 0.0, false};
    for (const Integration scheme :
         {Integration::Shi, Integration::BackwardEuler, Integration::Newmark, Integration::GeneralizedAlpha})
        if (scheme != scene.analysis.integration)
            axis.settings.push_back(
                analysisSetting(axis.name, word(scheme), [scheme](Analysis& a) { a.integration = scheme; }));
    return axis;
}

TradeAxis sleepAxis(const Scene& scene) {
    TradeAxis axis{sleepAxisName, {}, numericsOf(scene.analysis).sleepTolerance, false};
    for (const double value : sleepTolerances) {
        if (value == numericsOf(scene.analysis).sleepTolerance) continue;
        axis.settings.push_back(
            analysisSetting(axis.name, shortest(value), [value](Analysis& a) { a.sleepTolerance = value; }));
        if (value == 0.0) axis.settings.back().cost = costOfAwake;
    }
    return axis;
}

TradeAxis threadsAxis(int threads) {
    TradeAxis axis{threadsAxisName, {}, 0.0, false};
    axis.settings.push_back({axis.name, std::to_string(threads), {}, [](Scene&) {}});
    axis.settings.back().threads = threads;
    return axis;
}

bool hasOwnScheme(const Scene& scene) {
    return std::any_of(scene.stages.begin(), scene.stages.end(), [](const Stage& stage) { return stage.integration; });
}

}  // namespace

std::vector<TradeAxis> tradeAxes(const Scene& scene, const TradeModel& model) {
    const bool moves = hasStage(scene, StageKind::Dynamic);
    std::vector<TradeAxis> axes;
    if (hasDividedBolts(scene)) axes.push_back(divisionsAxis(scene, model));
    if (moves) axes.push_back(timeStepAxis(scene));
    if (hasStage(scene, StageKind::Static)) axes.push_back(incrementsAxis(scene));
    if (std::any_of(scene.blocks.begin(), scene.blocks.end(), [](const Block& block) { return block.subBlocks; }))
        axes.push_back(cellsAxis(scene));
    axes.push_back(penaltyAxis(scene));
    axes.push_back(contactAxis(scene));
    if (scene.blocks.size() <= mostOpenClose) axes.push_back(iterationAxis(scene));
    axes.push_back(toleranceAxis(scene));
    if (moves && !hasOwnScheme(scene)) axes.push_back(integrationAxis(scene));
    if (moves && !scene.analysis.modelEverything) axes.push_back(sleepAxis(scene));
    if (model.threads > 1) axes.push_back(threadsAxis(model.threads));
    if (TradeAxis bond = bondAxis(scene); !bond.settings.empty()) axes.push_back(std::move(bond));
    axes.push_back(presetAxis(scene));
    return axes;
}

TradeSetting combined(const std::string& axis, const std::vector<TradeSetting>& settings) {
    TradeSetting all{axis, "", {}, {}};
    std::vector<std::function<void(Scene&)>> changes;
    for (const TradeSetting& setting : settings) {
        all.text += (all.text.empty() ? "" : ", ") + setting.axis + " " + setting.text;
        all.overrides.insert(all.overrides.end(), setting.overrides.begin(), setting.overrides.end());
        all.cost *= setting.cost;
        all.threads = std::max(all.threads, setting.threads);
        changes.push_back(setting.apply);
    }
    all.apply = [changes](Scene& scene) {
        for (const auto& change : changes) change(scene);
    };
    return all;
}

}  // namespace keyblock
