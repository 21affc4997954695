// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of a list parameter may be numbers, texts or flags; the field table has no
// such kind, so they are turned into JSON texts before the table is read.
#include "solver/study/study_file.h"

#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/json/object_reader.h"
#include "solver/files/read_error.h"
#include "solver/files/regular_file.h"
#include "solver/files/scene/overrides.h"
#include "solver/files/text_file.h"
#include "solver/scene/check_report.h"
#include "solver/scene/pointer.h"
#include "solver/study/study_check.h"
#include "solver/study/study_fields.h"

#include <algorithm>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

const TextFileLimits studyLimits{longestJson, "give a study file", "give fewer values"};
const TextFileLimits sceneLimits{longestJson, "give a scene file", "give a smaller scene"};

JsonNode* memberOf(JsonNode& node, std::string_view key) { return const_cast<JsonNode*>(findMember(node, key)); }

void makeTexts(JsonNode& parameter) {
    JsonNode* values = memberOf(parameter, "values");
    auto* list = values ? std::get_if<JsonList>(&values->value) : nullptr;
    if (!list) return;
    for (JsonNode& value : *list)
        if (!std::holds_alternative<JsonList>(value.value) && !std::holds_alternative<JsonObject>(value.value) &&
            !std::holds_alternative<std::monostate>(value.value))
            value.value = jsonLine(value);
}

void makeTextsOfValues(JsonNode& root) {
    JsonNode* parameters = memberOf(root, "parameters");
    auto* list = parameters ? std::get_if<JsonList>(&parameters->value) : nullptr;
    if (!list) return;
    for (JsonNode& parameter : *list) makeTexts(parameter);
}

/// Whether something was reported at this position already, or around it.
bool isReported(const Problem& problem, const std::vector<Problem>& reported) {
    return std::any_of(reported.begin(), reported.end(), [&](const Problem& other) {
        return !other.pointer.empty() &&
               (isWithin(problem.pointer, other.pointer) || isWithin(other.pointer, problem.pointer));
    });
}

void addNew(std::vector<Problem>& problems, std::vector<Problem> more, const JsonNode& root) {
    for (Problem& problem : more) {
        if (isReported(problem, problems)) continue;
        problem.line = lineAt(root, problem.pointer);
        addProblem(problems, std::move(problem));
    }
}

/// A study as its table reads it, with the problems of single values.
struct PlainStudy {
    Study study;
    JsonNode root;
    std::vector<Problem> problems;
    bool isRead = false;  // the text is JSON
    bool isWhole = false;  // no value was left out
};

PlainStudy plainStudy(std::string_view text) {
    PlainStudy plain;
    JsonReading json = readJson(text);
    plain.problems = std::move(json.problems);
    if (!json.root) return plain;
    plain.isRead = true;
    plain.root = std::move(*json.root);
    makeTextsOfValues(plain.root);
    readObject(plain.root, studyStructure(), &plain.study, "", plain.problems);
    plain.isWhole = !hasErrors(plain.problems);
    for (StudyParameter& parameter : plain.study.parameters)
        if (parameter.name.empty()) parameter.name = parameter.path;
    CheckReport report;
    checkFields(studyStructure(), &plain.study, "", report);
    addNew(plain.problems, std::move(report.problems), plain.root);
    return plain;
}

bool namesRecords(const Scene& scene) {
    const auto names = [](const std::optional<Acceleration>& a) { return a && !a->file.empty(); };
    return std::any_of(scene.stages.begin(), scene.stages.end(), [&](const Stage& stage) {
        return names(stage.baseAcceleration) || names(stage.bodyAcceleration);
    });
}

void readSceneOf(const fs::path& study, StudyReading& reading, std::vector<Problem>& sceneProblems,
                 const PlainStudy& plain, const std::string* scene) {
    const fs::path path = study.parent_path() / plain.study.scene;
    try {
        reading.sceneText = scene ? *scene : readTextFile(path, sceneLimits);
    } catch (const CannotRead& error) {
        addProblem(reading.problems, {Severity::Error, "", lineAt(plain.root, "/scene"), "/scene", error.what(),
                                      "The path is relative to the study file"});
        return;
    }
    reading.scene = readSceneText(reading.sceneText, path.string(), {}, path.parent_path());
    sceneProblems = reading.scene->problems;
    if (reading.scene->scene && namesRecords(*reading.scene->scene))
        reading.sceneText = wholeSceneText(*reading.scene->scene);
}

}  // namespace

bool isStudyText(std::string_view text) {
    const JsonReading json = readJson(text);
    const JsonNode* format = json.root ? findMember(*json.root, "format") : nullptr;
    const auto* word = format ? std::get_if<std::string>(&format->value) : nullptr;
    return word && *word == "keyblock-study";
}

bool isStudyFile(const fs::path& path) {
    try {
        return isStudyText(readTextFile(path, studyLimits));
    } catch (const CannotRead&) {
        return false;
    }
}

StudyReading readStudyFile(const fs::path& path) {
    try {
        return readStudyText(readTextFile(path, studyLimits), path);
    } catch (const CannotRead& error) {
        StudyReading reading;
        reading.problems.push_back({Severity::Error, path.string(), 0, "", error.what(), "Give a study file"});
        return reading;
    }
}

StudyReading readStudyText(std::string text, const fs::path& path, const std::string* scene) {
    StudyReading reading;
    reading.text = std::move(text);
    PlainStudy plain = plainStudy(reading.text);
    reading.problems = std::move(plain.problems);
    reading.isWhole = plain.isWhole;
    std::vector<Problem> sceneProblems;
    if (plain.isRead && !plain.study.scene.empty()) readSceneOf(path, reading, sceneProblems, plain, scene);
    if (reading.scene && reading.scene->scene)
        addNew(reading.problems, checkStudy(plain.study, *reading.scene, reading.sceneText), plain.root);
    nameOrigins(reading.problems, path.string(), {});
    std::stable_sort(reading.problems.begin(), reading.problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    for (Problem& problem : sceneProblems) addProblem(reading.problems, std::move(problem));
    if (plain.isRead) reading.partly = plain.study;
    if (!hasErrors(reading.problems)) reading.study = std::move(plain.study);
    return reading;
}

Study readCheckedStudy(std::string_view text, const std::string& name) {
    PlainStudy plain = plainStudy(text);
    for (const Problem& problem : plain.problems)
        if (problem.severity == Severity::Error)
            throw CannotRead("cannot read " + name + ": " + problem.message + "; plan the sweep again");
    return std::move(plain.study);
}

}  // namespace keyblock
