// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only part of the command line that uses the JSON library. Numbers that are not
// finite become null; text that is not valid UTF-8 is repaired.
#include "app/cli/json_answers.h"

#include "app/cli/preset_listing.h"
#include "app/cli/summary_text.h"
#include "solver/results/bolt_use.h"
#include "solver/results/chains.h"
#include "solver/results/event_groups.h"
#include "solver/results/quantity.h"
#include "solver/results/verdict.h"
#include "solver/results/result_names.h"
#include "solver/run/failed_parts.h"
#include "solver/scene/solved_blocks.h"
#include "solver/scene/enum_names.h"

#include <nlohmann/json.hpp>

namespace keyblock::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

template <typename Value>
Json orNull(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json stageJson(const Scene& scene, const StageRecord& record) {
    const std::size_t index = record.result.stage;
    Json json{{"name", scene.stages[index].name}, {"kind", wordOf(scene.stages[index].kind)}};
    json["outcome"] = record.ended ? Json(wordOf(record.result.outcome)) : Json(nullptr);
    json["time_s"] = record.ended ? Json(record.result.time) : Json(nullptr);
    json["steps"] = record.ended ? Json(record.result.steps) : Json(nullptr);
    const Health& health = record.result.health;
    const StepWork& work = health.work;
    json["solved"] = health.steps;
    json["work"] = {{"total", workOf(work)},
                    {"iterations", health.passes},
                    {"factorizations", work.factorizations},
                    {"full_factorizations", work.fullFactorizations},
                    {"ranks", work.ranks},
                    {"solves", work.solves},
                    {"products", work.products},
                    {"sweeps", work.sweeps}};
    return json;
}

Json healthJson(const std::optional<RunHealth>& health) {
    if (!health)
        return {{"passes_mean", nullptr},
                {"work_mean", nullptr},
                {"factorizations_mean", nullptr},
                {"full_factorizations_mean", nullptr},
                {"awake_mean", nullptr},
                {"step_cuts", nullptr},
                {"energy_cuts", nullptr},
                {"max_penetration_ratio", nullptr},
                {"balance_error", nullptr},
                {"residual", nullptr}};
    return {{"passes_mean", health->passesMean},
            {"work_mean", health->workMean},
            {"factorizations_mean", health->factorizationsMean},
            {"full_factorizations_mean", health->fullFactorizationsMean},
            {"awake_mean", health->awakeMean ? Json(*health->awakeMean) : Json(nullptr)},
            {"step_cuts", health->stepCuts},
            {"energy_cuts", health->energyCuts},
            {"max_penetration_ratio", health->maxPenetrationRatio},
            {"balance_error", health->balanceError},
            {"residual", health->residual}};
}

/// Events are numbered from 0, in the order of the events table.
Json chainsJson(const RunSource& run, const std::vector<Event>& events) {
    Json chains = Json::array();
    for (const auto& chain : causeChains(events)) {
        Json links = Json::array();
        for (const std::size_t i : chain) {
            const Event& event = events[i];
            Json link{{"event", i}, {"kind", wordOf(event.kind)}, {"cause", event.cause}};
            if (event.bolt >= 0) link["bolt"] = boltName(run.scene(), event.bolt);
            if (event.node >= 0) link["node"] = event.node;
            if (event.element >= 0) link["element"] = event.element;
            if (event.block >= 0) link["block"] = blockName(run.blockNames(), event.block);
            links.push_back(link);
        }
        chains.push_back(links);
    }
    return chains;
}

/// Adds the peak of a force or moment, its position along the bolt, and when it occurred. Position and time are null
/// for a bolt that carried none.
void putPeak(Json& json, const RunSource& run, const BoltPeak& peak, const std::string& key, const std::string& unit,
             const std::string& when) {
    const bool any = peak.stage >= 0;
    json[key + unit] = peak.value;
    json[key + "_at_m"] = any ? Json(peak.at) : Json(nullptr);
    json[when + "stage"] = any ? Json(stageName(run.scene(), peak.stage)) : Json(nullptr);
    json[when + "time_s"] = any ? Json(peak.time) : Json(nullptr);
}

/// The energies of the bolt are those of the last frame.
Json boltJson(const RunSource& run, const BoltUse& use, const BoltFrame& last) {
    const std::string name = boltName(run.scene(), use.bolt);
    Json json{{"bolt", name}};
    putPeak(json, run, use.extremes.axialForce, "axial", "_N", "");
    putPeak(json, run, use.extremes.shearForce, "shear", "_N", "shear_");
    putPeak(json, run, use.extremes.moment, "moment", "_Nm", "moment_");
    for (const BoltStrengthRow& row : boltStrengths)
        json["use"][std::string(row.key)] = orNull(use.use[static_cast<std::size_t>(row.strength)]);
    json["governs"] = use.governs ? Json(rowOf(*use.governs).key) : Json(nullptr);
    json["holds"] = Json::array();
    for (const int block : use.holds) json["holds"].push_back(blockName(run.blockNames(), block));
    json["name"] = name;
    json["elastic_J"] = last.elasticEnergy;
    json["plastic_J"] = last.plasticEnergy;
    json["bond_J"] = last.bondEnergy;
    return json;
}

Json boltsJson(const RunSource& run) {
    Json bolts = Json::array();
    if (run.frames().empty())
        return bolts;
    const Frame frame = run.frame(run.frames().size() - 1);
    for (const BoltUse& use : boltUses(run))
        bolts.push_back(boltJson(run, use, frame.bolts[use.bolt]));
    return bolts;
}

Json caseJson(const CaseResult& result) {
    return {{"name", result.name},           {"quantity", result.quantity},   {"measured", result.measured},
            {"expected", result.expected},   {"tolerance", result.tolerance}, {"relative", result.relative},
            {"passed", result.passed},       {"seconds", result.seconds}};
}

Json paperTableJson(const PaperTable& table) {
    Json rows = Json::array();
    for (const PaperRow& row : table.rows)
        rows.push_back({{"quantity", row.quantity},
                        {"unit", row.unit},
                        {"paper", orNull(row.paper)},
                        {"reference", orNull(row.reference)},
                        {"keyblock", row.keyblock},
                        {"tolerance", row.tolerance},
                        {"passed", row.passed}});
    return {{"title", table.title}, {"rows", rows}};
}

}  // namespace

namespace {

Json cutJson(const SceneCut& cut) {
    Json reports = Json::array();
    for (const CutNote& note : cut.notes)
        reports.push_back({{"kind", wordOf(note.kind)},
                           {"x_m", note.place.x()},
                           {"y_m", note.place.y()},
                           {"message", noteText(cut, note)}});
    return {{"blocks", cut.blocks},
            {"vertices", cut.vertices},
            {"edges", cut.edges},
            {"area_m2", cut.area},
            {"tolerance_m", cut.tolerance},
            {"min_area_m2", cut.minArea},
            {"min_width_m", cut.minWidth},
            {"open_blocks", cut.open},
            {"splits", cut.split},
            {"reports", reports}};
}

Json estimateJson(const CostEstimate& estimate) {
    Json stages = Json::array();
    for (const StageCost& stage : estimate.stages)
        stages.push_back({{"name", stage.name},
                          {"steps", stage.steps},
                          {"passes", stage.passes},
                          {"least", stage.least},
                          {"most", stage.most}});
    return {{"seconds", estimate.seconds},
            {"seconds_least", estimate.secondsLeast},
            {"seconds_most", estimate.secondsMost},
            {"memory_MB", estimate.memory / 1e6},
            {"pass_seconds", estimate.passSeconds},
            {"step_seconds", estimate.stepSeconds},
            {"stages", stages},
            {"assumes", estimate.assumes}};
}

Json modelSummaryJson(const ModelSummary& summary) {
    const ModelCounts& counts = summary.counts;
    Json leftOut = Json::array();
    for (const LeftOut& part : summary.leftOut)
        leftOut.push_back({{"what", part.what}, {"why", part.why}, {"saves", part.saves}});
    Json next = Json::array();
    for (const NextLeftOut& one : summary.next)
        next.push_back({{"setting", one.axis},
                        {"what", one.what},
                        {"costs", one.costs},
                        {"saves", one.saves},
                        {"set", one.set},
                        {"measured", one.measured}});
    return {{"blocks", counts.blocks},
            {"cells", counts.cells},
            {"plates", counts.plates},
            {"fixed", counts.fixed},
            {"contacts", counts.contacts},
            {"bolts", counts.bolts},
            {"nodes", counts.nodes},
            {"unknowns",
             {{"blocks", counts.blockUnknowns}, {"plates", counts.plateUnknowns}, {"bolts", counts.boltUnknowns}}},
            {"left_out", leftOut},
            {"next", next},
            {"estimate", estimateJson(summary.estimate)}};
}

Json presetJson(const Analysis& analysis, std::span<const std::string> overrides) {
    Json settings = Json::array();
    for (const SettingInUse& setting : settingsInUse(analysis)) {
        const auto* word = std::get_if<std::string>(&setting.value);
        settings.push_back({{"key", setting.field->key},
                            {"value", word ? Json(*word) : Json(std::get<double>(setting.value))},
                            {"from", originOf(setting, overrides)}});
    }
    return {{"name", presetWords[static_cast<std::size_t>(analysis.preset)]},
            {"text", presetText(analysis)},
            {"settings", settings}};
}

Json problemsJson(std::span<const Problem> problems) {
    Json list = Json::array();
    for (const Problem& problem : problems)
        list.push_back({{"severity", wordOf(problem.severity)},
                        {"pointer", problem.pointer},
                        {"line", problem.line > 0 ? Json(problem.line) : Json(nullptr)},
                        {"message", problem.message},
                        {"remedy", problem.remedy}});
    return list;
}

}  // namespace

std::string studyCheckJson(std::span<const Problem> problems, std::optional<long> cases) {
    return dumped({{"problems", problemsJson(problems)}, {"cases", cases ? Json(*cases) : Json(nullptr)}}, 2);
}

std::string checkJson(const SceneReading& reading, const std::optional<ModelSummary>& summary,
                      std::span<const std::string> overrides) {
    Json answer{{"problems", problemsJson(reading.problems)}};
    if (reading.cut && !reading.cut->sources.empty())
        answer["cut"] = cutJson(*reading.cut);
    if (reading.scene) answer["preset"] = presetJson(reading.scene->analysis, overrides);
    if (summary)
        answer["census"] = modelSummaryJson(*summary);
    return dumped(answer, 2);
}

namespace {

Json verdictJson(const RunSource& run, const Verdict& verdict) {
    Json blocks = Json::array();
    for (const StageUnstable& one : verdict.blocks)
        blocks.push_back({{"block", blockName(run.blockNames(), one.block.block)},
                          {"mode", wordOf(one.block.mode)},
                          {"moved_m", one.block.moved},
                          {"weight_N", one.block.weight},
                          {"stage", stageName(run.scene(), one.stage)}});
    const FailedParts failed = failedParts(run, verdict);
    Json joints = Json::array(), bolts = Json::array();
    for (const FailedJoint& joint : failed.joints)
        joints.push_back({{"block_a", blockName(run.blockNames(), joint.blockA)},
                          {"block_b", blockName(run.blockNames(), joint.blockB)},
                          {"mode", joint.opened ? "opened" : "slid"},
                          {"slip_m", joint.slip},
                          {"opening_m", joint.opening},
                          {"x_m", joint.position.x()},
                          {"y_m", joint.position.y()},
                          {"stage", stageName(run.scene(), joint.stage)}});
    for (const FailedBolt& bolt : failed.bolts)
        bolts.push_back({{"bolt", boltName(run.scene(), bolt.bolt)},
                         {"event", wordOf(bolt.event)},
                         {"stage", stageName(run.scene(), bolt.stage)},
                         {"time_s", bolt.time}});
    return {{"stands", orNull(verdict.stands)}, {"blocks", blocks}, {"joints", joints}, {"bolts", bolts}};
}

Json warningsJson(const RunSource& run) {
    Json warnings = Json::array();
    for (const StageWarning& warning : stageWarnings(run))
        warnings.push_back({{"stage", warning.stage < 0 ? Json(nullptr) : Json(stageName(run.scene(), warning.stage))},
                            {"message", warning.text}});
    return warnings;
}

Json worstBalanceJson(const RunSource& run, const std::optional<StageResult>& worst) {
    if (!worst) return nullptr;
    return {{"block", blockName(run.blockNames(), worst->health.worst.block)},
            {"ratio", worst->health.worst.share},
            {"force_N", worst->health.worst.force},
            {"stage", stageName(run.scene(), worst->stage)}};
}

Json quantitiesJson(const RunSource& run, const std::vector<StageRecord>& records, const std::vector<Event>& events) {
    const std::vector<HistoryRow> history = run.history();
    const RecordedRun recorded{run.scene(), history, events, records};
    Json list = Json::array();
    for (const std::string& text : run.scene().quantities) {
        const Measurement measurement = measure(text, recorded);
        list.push_back({{"quantity", text},
                        {"value", orNull(measurement.value)},
                        {"order", measurement.order},
                        {"problem", measurement.problem}});
    }
    return list;
}

Json estimateJson(const ErrorEstimate& estimate) {
    Json quantities = Json::array();
    for (const QuantityEstimate& one : estimate.quantities)
        quantities.push_back({{"quantity", one.quantity},
                              {"value", orNull(one.value)},
                              {"error", orNull(one.error)},
                              {"remark", one.remark}});
    return {{"refinements", estimate.refinements}, {"quantities", quantities}};
}

Json looseJson(const RunSource& run, const std::vector<StageRecord>& records) {
    Json names = Json::array();
    for (const StageRecord& record : records)
        for (const int block : record.result.loose) names.push_back(blockName(run.blockNames(), block));
    return names;
}

}  // namespace

std::string infoJson(const RunStore& store, const std::optional<ErrorEstimate>& estimate) {
    const std::vector<StageRecord> records = store.stages();
    Json stages = Json::array();
    for (const StageRecord& record : records)
        stages.push_back(stageJson(store.scene(), record));
    const std::vector<Event> happened = store.events();
    Json events = Json::object();
    const EventCounts counts(happened);
    for (const EventKindRow& row : eventKinds)
        if (const long count = counts.of(row.kind); count > 0) events[std::string(row.key)] = count;
    return dumped({{"title", store.scene().title},
                   {"program_version", store.programVersion()},
                   {"scene_hash", store.sceneHash()},
                   {"preset", presetText(store.scene().analysis)},
                   {"stages", stages},
                   {"frames", store.frames().size()},
                   {"events", events},
                   {"chains", chainsJson(store, happened)},
                   {"bolts", boltsJson(store)},
                   {"health", healthJson(healthOf(records))},
                   {"verdict", verdictJson(store, verdictOf(records, store.scene()))},
                   {"worst_balance", worstBalanceJson(store, worstBalanced(records))},
                   {"warnings", warningsJson(store)},
                   {"loose", looseJson(store, records)},
                   {"quantities", quantitiesJson(store, records, happened)},
                   {"estimated_errors", estimate ? estimateJson(*estimate) : Json(nullptr)}},
                  2);
}

namespace {

Json comparedRunJson(const RunStore& store, const Verdict& verdict, const std::vector<int>& settled) {
    Json unstable = Json::array(), atRest = Json::array();
    for (const StageUnstable& one : verdict.blocks) unstable.push_back(blockName(store.blockNames(), one.block.block));
    for (const int block : settled) atRest.push_back(blockName(store.blockNames(), block));
    return {{"title", store.scene().title},
            {"scene_hash", store.sceneHash()},
            {"stands", orNull(verdict.stands)},
            {"unstable", unstable},
            {"settled", atRest}};
}

Json savedJson(const RunStore& a, const RunStore& b, const SavedBlock& one) {
    const RunStore &falling = one.fallsInA ? a : b, &stable = one.fallsInA ? b : a;
    Json holders = Json::array();
    for (const HoldingBolt& bolt : one.heldBy)
        holders.push_back({{"bolt", boltName(stable.scene(), bolt.bolt)},
                           {"force_N", bolt.force},
                           {"on", blockName(stable.blockNames(), bolt.on)}});
    return {{"block", blockName(a.blockNames(), one.block.a)},
            {"block_b", blockName(b.blockNames(), one.block.b)},
            {"falls_in", one.fallsInA ? "a" : "b"},
            {"mode", wordOf(one.fall.block.mode)},
            {"stage", stageName(falling.scene(), one.fall.stage)},
            {"moved_m", one.moved},
            {"weight_N", one.fall.block.weight},
            {"held_by", holders}};
}

Json comparedBoltJson(const std::optional<BoltUse>& use) {
    if (!use) return nullptr;
    return {{"axial_N", use->extremes.axialForce.value},
            {"shear_N", use->extremes.shearForce.value},
            {"moment_Nm", use->extremes.moment.value},
            {"use", use->governs ? Json(use->highest()) : Json(nullptr)},
            {"governs", use->governs ? Json(rowOf(*use->governs).key) : Json(nullptr)}};
}

}  // namespace

std::string compareJson(const RunStore& a, const RunStore& b, const RunComparison& found) {
    Json saved = Json::array(), displacements = Json::array(), bolts = Json::array();
    for (const SavedBlock& one : found.saved) saved.push_back(savedJson(a, b, one));
    for (const BlockDifference& one : found.blocks)
        displacements.push_back({{"block", blockName(a.blockNames(), one.block.a)},
                                 {"ux_a_m", one.a.x()},
                                 {"uy_a_m", one.a.y()},
                                 {"ux_b_m", one.b.x()},
                                 {"uy_b_m", one.b.y()},
                                 {"difference_m", one.size()}});
    for (const BoltDifference& one : found.bolts) {
        const bool both = one.a && one.b;
        bolts.push_back({{"bolt", one.name}, {"a", comparedBoltJson(one.a)}, {"b", comparedBoltJson(one.b)}});
        bolts.back()["axial_difference_N"] = both ? Json(one.a->extremes.axialForce.value -
                                                         one.b->extremes.axialForce.value)
                                                  : Json(nullptr);
    }
    return dumped({{"a", comparedRunJson(a, found.a, found.settledA)},
                   {"b", comparedRunJson(b, found.b, found.settledB)},
                   {"blocks", {{"shared", found.shared}, {"only_a", found.onlyA}, {"only_b", found.onlyB}}},
                   {"saved", saved},
                   {"displacements", displacements},
                   {"bolts", bolts}},
                  2);
}

std::string casesJson(std::span<const CaseResult> results) {
    Json list = Json::array();
    for (const CaseResult& result : results)
        list.push_back(caseJson(result));
    return dumped({{"cases", list}}, 2);
}

std::string paperJson(std::span<const PaperTable> tables) {
    Json list = Json::array();
    for (const PaperTable& table : tables)
        list.push_back(paperTableJson(table));
    return dumped({{"tables", list}}, 2);
}

std::string stressJson(const StressTest& stress) {
    Json pushes = Json::array(), values = Json::array();
    for (const StressPoint& point : stress.points)
        pushes.push_back({{"axis", point.push.axis},
                          {"push", point.push.text},
                          {"physical", point.push.physical},
                          {"ending", wordOf(point.ending)},
                          {"change", point.moved},
                          {"quantity", point.quantity},
                          {"reason", point.reason},
                          {"warnings", point.warnings},
                          {"remedy", point.push.remedy},
                          {"seconds", point.seconds}});
    for (const Measurement& value : stress.own.values) values.push_back(orNull(value.value));
    const int first = firstToBreak(stress);
    return dumped({{"quantities", stress.quantities},
                   {"own", {{"seconds", stress.own.seconds}, {"values", values}, {"failure", stress.own.failure}}},
                   {"pushes", pushes},
                   {"breaks_first", first < 0 ? Json(nullptr) : Json(first)},
                   {"answer", stressAnswer(stress)},
                   {"interrupted", stress.interrupted}},
                  2);
}

namespace {

Json extremeRunsJson(const std::vector<ExtremeRun>& runs) {
    Json list = Json::array();
    for (const ExtremeRun& run : runs)
        list.push_back({{"value", run.value},
                        {"ending", wordOf(run.ending)},
                        {"quantity", run.quantity},
                        {"measured", run.measured},
                        {"expected", run.expected},
                        {"tolerance", run.tolerance},
                        {"reason", run.reason},
                        {"seconds", run.seconds}});
    return list;
}

}  // namespace

std::string extremesJson(std::span<const ExtremeCaseRuns> cases, std::span<const RandomExtremes> random) {
    Json caseList = Json::array(), randomList = Json::array();
    std::vector<ExtremeRun> all;
    for (const ExtremeCaseRuns& each : cases) {
        caseList.push_back({{"name", each.one.name},
                            {"scene", each.one.scene},
                            {"axis", each.one.axis},
                            {"property", each.one.property},
                            {"runs", extremeRunsJson(each.runs)}});
        all.insert(all.end(), each.runs.begin(), each.runs.end());
    }
    for (const RandomExtremes& each : random) {
        randomList.push_back({{"seed", each.seed}, {"runs", extremeRunsJson(each.runs)}});
        all.insert(all.end(), each.runs.begin(), each.runs.end());
    }
    const ExtremeCounts counts = countsOf(all);
    Json number;
    for (int ending = 0; ending < extremeEndings; ++ending)
        number[std::string(wordOf(static_cast<ExtremeEnding>(ending)))] =
            counts.endings[static_cast<std::size_t>(ending)];
    number["median_s"] = counts.median;
    number["longest_s"] = counts.longest;
    return dumped({{"cases", caseList}, {"random", randomList}, {"counts", number}}, 2);
}

namespace {

std::string_view outcomeWord(const SafetyFactor& found) {
    if (found.cutShort) return wordOf(*found.cutShort);
    if (found.nothingToFreeze) return "fails-at-1";
    if (!found.upper) return "stands-at-1000";
    return found.lower ? "bracketed" : "falls-at-0.001";
}

std::string_view answerWord(const SafetyFactor& found) {
    if (found.cutShort || found.nothingToFreeze) return "undecided";
    if (!found.upper) return "stands_always";
    return found.lower ? "bracketed" : "falls_always";
}

/// The unstable blocks of the run at the upper end of the bracket.
Json safetyBlocksJson(const std::vector<std::string>& names, const SafetyFactor& found) {
    Json blocks = Json::array();
    for (const SafetyRun& run : found.runs) {
        if (run.factor != found.upper) continue;
        for (const UnstableBlock& block : run.end.unstable)
            blocks.push_back({{"block", blockName(names, block.block)},
                              {"mode", wordOf(block.mode)},
                              {"moved_m", block.moved},
                              {"weight_N", block.weight}});
    }
    return blocks;
}

Json safetyRunJson(const Scene& scene, const SafetyRun& run) {
    return {{"factor", run.factor},
            {"stands", run.stands},
            {"stage", stageName(scene, run.end.stage)},
            {"outcome", wordOf(run.end.outcome)},
            {"steps", run.end.steps},
            {"message", run.end.message}};
}

Json modeJson(const Scene& scene, const FailureMode& mode) {
    const std::vector<std::string> names = blockNames(scene);
    Json blocks = Json::array(), joints = Json::array();
    for (const MovingBlock& block : mode.blocks)
        blocks.push_back({{"name", blockName(names, block.block)},
                          {"movement", wordOf(block.movement)},
                          {"displacement_m", {block.displacement.x(), block.displacement.y()}},
                          {"rotation_rad", block.rotation}});
    for (const MovingJoint& joint : mode.joints) {
        const std::size_t material = joint.jointMaterial;
        const bool named = joint.jointMaterial >= 0 && material < scene.jointMaterials.size();
        joints.push_back({{"blocks", {blockName(names, joint.blockA), blockName(names, joint.blockB)}},
                          {"joint_material", named ? Json(scene.jointMaterials[material].first) : Json(nullptr)},
                          {"x_m", joint.position.x()},
                          {"y_m", joint.position.y()},
                          {"slip_m", joint.slip},
                          {"opening_m", joint.opening}});
    }
    return {{"blocks", blocks}, {"joints", joints}};
}

}  // namespace

std::string safetyJson(const Scene& solved, const SafetyFactor& found) {
    Json runs = Json::array();
    for (const SafetyRun& run : found.runs)
        runs.push_back(safetyRunJson(solved, run));
    Json answer{{"reduce", wordsOf(solved.safety.reduce)[static_cast<std::size_t>(solved.safety.reduce)]},
                {"bolt_forces", wordsOf(solved.safety.boltForces)[static_cast<std::size_t>(solved.safety.boltForces)]},
                {"tolerance", solved.safety.tolerance},
                {"factor", {{"lower", orNull(found.lower)}, {"upper", orNull(found.upper)}}},
                {"answer", answerWord(found)},
                {"lower", orNull(found.lower)},
                {"upper", orNull(found.upper)},
                {"outcome", outcomeWord(found)},
                {"blocks", safetyBlocksJson(blockNames(solved), found)},
                {"runs", runs},
                {"mode", found.mode ? modeJson(solved, *found.mode) : Json(nullptr)}};
    return dumped(answer, 2);
}

std::string progressJson(const ProgressLine& line) {
    return dumped({{"stage", line.stage},
                   {"time_s", line.time},
                   {"fraction", line.fraction},
                   {"eta_s", orNull(line.secondsLeft)},
                   {"passes", line.passes},
                   {"events", line.events},
                   {"search", line.search.empty() ? Json(nullptr) : Json(line.search)}},
                  -1);
}

}  // namespace keyblock::cli
