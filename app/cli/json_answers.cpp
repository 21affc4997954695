// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only place of the command line that knows the JSON library. Numbers that are
// not finite become null; text that is no UTF-8 is repaired.
#include "app/cli/json_answers.h"

#include "app/cli/run_summary.h"
#include "solver/results/chains.h"
#include "solver/results/words.h"

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
    const auto index = static_cast<std::size_t>(record.result.stage);
    Json json{{"name", scene.stages[index].name}, {"kind", wordOf(scene.stages[index].kind)}};
    json["outcome"] = record.ended ? Json(wordOf(record.result.outcome)) : Json(nullptr);
    json["time_s"] = record.ended ? Json(record.result.time) : Json(nullptr);
    json["steps"] = record.ended ? Json(record.result.steps) : Json(nullptr);
    return json;
}

Json healthJson(const std::optional<RunHealth>& health) {
    if (!health)
        return {{"passes_mean", nullptr},
                {"step_cuts", nullptr},
                {"max_penetration_ratio", nullptr},
                {"balance_error", nullptr},
                {"residual", nullptr}};
    return {{"passes_mean", health->passesMean},
            {"step_cuts", health->stepCuts},
            {"max_penetration_ratio", health->maxPenetrationRatio},
            {"balance_error", health->balanceError},
            {"residual", health->residual}};
}

/// Event numbers count from 0, in the order of the table of events.
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

/// Of the last frame.
Json boltsJson(const RunSource& run) {
    Json bolts = Json::array();
    if (run.frames().empty())
        return bolts;
    const Frame frame = run.frame(run.frames().size() - 1);
    for (std::size_t b = 0; b < frame.bolts.size(); ++b)
        bolts.push_back({{"name", boltName(run.scene(), static_cast<int>(b))},
                         {"elastic_J", frame.bolts[b].elasticEnergy},
                         {"plastic_J", frame.bolts[b].plasticEnergy},
                         {"bond_J", frame.bolts[b].bondEnergy}});
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

Json censusJson(const Census& census) {
    const CensusCounts& counts = census.counts;
    Json leftOut = Json::array();
    for (const LeftOut& part : census.leftOut)
        leftOut.push_back({{"what", part.what}, {"why", part.why}, {"saves", part.saves}});
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
            {"estimate", estimateJson(census.estimate)}};
}

}  // namespace

std::string checkJson(const SceneReading& reading, const std::optional<Census>& census) {
    Json list = Json::array();
    for (const Problem& problem : reading.problems)
        list.push_back({{"severity", wordOf(problem.severity)},
                        {"pointer", problem.pointer},
                        {"line", problem.line > 0 ? Json(problem.line) : Json(nullptr)},
                        {"message", problem.message},
                        {"remedy", problem.remedy}});
    Json answer{{"problems", list}};
    if (reading.cut && !reading.cut->sources.empty())
        answer["cut"] = cutJson(*reading.cut);
    if (census)
        answer["census"] = censusJson(*census);
    return dumped(answer, 2);
}

std::string infoJson(const RunStore& store) {
    const std::vector<StageRecord> records = store.stages();
    Json stages = Json::array();
    for (const StageRecord& record : records)
        stages.push_back(stageJson(store.scene(), record));
    const std::vector<Event> happened = store.events();
    Json events = Json::object();
    for (const auto& [kind, count] : countByKind(happened))
        events[std::string(wordOf(kind))] = count;
    return dumped({{"title", store.scene().title},
                   {"program_version", store.programVersion()},
                   {"scene_hash", store.sceneHash()},
                   {"stages", stages},
                   {"frames", store.frames().size()},
                   {"events", events},
                   {"chains", chainsJson(store, happened)},
                   {"bolts", boltsJson(store)},
                   {"health", healthJson(healthOf(records))}},
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

std::string progressJson(const ProgressLine& line) {
    return dumped({{"stage", line.stage},
                   {"time_s", line.time},
                   {"fraction", line.fraction},
                   {"eta_s", orNull(line.secondsLeft)},
                   {"passes", line.passes},
                   {"events", line.events}},
                  -1);
}

}  // namespace keyblock::cli
