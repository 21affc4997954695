// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A text becomes a scene in these steps: tree, overrides, version, fields, bolt types,
// checks. Each step adds the problems that it finds and the next step continues with
// what is usable, so that the user sees all problems at once. Problems that follow
// from an error already reported are omitted.
#include "solver/files/scene/scene_file.h"

#include "solver/engine/setup/mesh_check.h"
#include "solver/files/scene/bolt_library.h"
#include "solver/files/scene/bolt_type_reader.h"
#include "solver/files/json/field_json.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/json/object_reader.h"
#include "solver/files/regular_file.h"
#include "solver/files/scene/overrides.h"
#include "solver/files/scene/record_file.h"
#include "solver/files/scene/scene_from_tree.h"
#include "solver/files/scene/scene_version.h"
#include "solver/scene/check.h"
#include "solver/scene/field.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace keyblock {

namespace {

using Problems = std::vector<Problem>;

std::vector<std::string_view> allBoltTypeNames(const Scene& scene) {
    std::vector<std::string_view> names;
    for (const std::vector<BoltType>* types : {&scene.boltTypes, &builtInBoltTypes()})
        for (const BoltType& type : *types)
            names.push_back(type.name);
    return names;
}

// Called before the built-in types in use are added to those of the scene: only here are all names known.
void checkBoltTypeNames(const Scene& scene, const JsonNode& root, Problems& problems) {
    const auto check = [&](const std::string& type, const std::string& pointer) {
        if (!type.empty() && !isFull(problems) && !findBoltType(scene, type) && !findBuiltInBoltType(type))
            addProblem(problems, {Severity::Error, "", lineAt(root, pointer), pointer,
                                  "there is no bolt type " + inQuotes(type),
                                  suggestion(type, allBoltTypeNames(scene))});
    };
    for (std::size_t i = 0; i < scene.bolts.size(); ++i)
        check(scene.bolts[i].type, under(under("/bolts", i), "type"));
    for (std::size_t i = 0; i < scene.boltPatterns.size(); ++i)
        check(scene.boltPatterns[i].type, under(under("/bolt_patterns", i), "type"));
}

Scene readScene(const JsonNode& root, Problems& unread, Problems& lost) {
    Scene scene;
    readObject(root, sceneStructure(), &scene, "", unread, {"bolt_types"});
    if (const JsonNode* types = findMember(root, "bolt_types"))
        scene.boltTypes = readBoltTypes(*types, builtInBoltTypes(), "/bolt_types", unread);
    checkBoltTypeNames(scene, root, lost);
    addUsedBuiltInBoltTypes(scene);
    return scene;
}

RecordReading recordOf(const std::string& file, const RecordFolder& folder) {
    if (!folder)
        return {{}, {{"a run store contains its records, and no other file is read for it", "Run the scene again"}}};
    return readRecordFile(*folder / file);
}

void readRecord(Acceleration& acceleration, const std::string& pointer, const JsonNode& root,
                const RecordFolder& folder, Problems& problems) {
    if (acceleration.file.empty() || !acceleration.record.empty())
        return;
    RecordReading reading = recordOf(acceleration.file, folder);
    acceleration.record = std::move(reading.record);
    const std::string place = under(pointer, "file");
    for (RecordReading::Fault& fault : reading.faults)
        addProblem(problems, {Severity::Error, "", lineAt(root, place), place,
                              acceleration.file + ": " + fault.message, std::move(fault.remedy)});
}

// Reads the files named in the scene into the scene, so that later steps do not depend on files.
void readRecords(Scene& scene, const JsonNode& root, const RecordFolder& folder, Problems& problems) {
    for (std::size_t i = 0; i < scene.stages.size(); ++i) {
        Stage& stage = scene.stages[i];
        const std::string pointer = under("/stages", i);
        if (stage.baseAcceleration)
            readRecord(*stage.baseAcceleration, under(pointer, "base_acceleration"), root, folder, problems);
        if (stage.bodyAcceleration)
            readRecord(*stage.bodyAcceleration, under(pointer, "body_acceleration"), root, folder, problems);
    }
}

// True if the error is in the key that decides whether the field of the problem applies at all.
bool decides(const Problem& error, const Problem& problem) {
    const Field* field = sceneFieldAt(problem.pointer);
    const std::size_t parent = problem.pointer.rfind('/');
    return field && !field->only.key.empty() &&
           error.pointer == under(problem.pointer.substr(0, parent), field->only.key);
}

// True if an error has been reported for the same position, for something inside it, for something that contains it, or
// for the key that decides whether it applies.
bool isExplained(const Problem& problem, const Problems& errors) {
    return std::any_of(errors.begin(), errors.end(), [&](const Problem& error) {
        const bool haveBothAPlace = !problem.pointer.empty() && !error.pointer.empty();
        return haveBothAPlace &&
               (isWithin(problem.pointer, error.pointer) || isWithin(error.pointer, problem.pointer) ||
                decides(error, problem));
    });
}

// True if a whole list could not be read; everything that refers to it would then seem wrong.
bool lacksWholeList(const Problems& fieldProblems) {
    return std::any_of(fieldProblems.begin(), fieldProblems.end(), [](const Problem& problem) {
        const Field* field = problem.pointer.empty() ? nullptr
                                                     : findField(sceneStructure(), problem.pointer.substr(1));
        return field && hasChildren(*field);
    });
}

// Adds the problems that concern more than a single field; those of single fields are in `fieldProblems`.
void addSense(const Scene& scene, const JsonNode& root, const Problems& fieldProblems, Problems& problems,
              std::optional<SceneCut>& cut) {
    for (Problem& problem : lacksWholeList(fieldProblems) ? checkValues(scene) : checkScene(scene, &cut)) {
        if (isExplained(problem, fieldProblems))
            continue;
        problem.line = lineAt(root, problem.pointer);
        addProblem(problems, std::move(problem));
    }
    if (hasErrors(problems) || hasErrors(fieldProblems))
        return;
    for (Problem& problem : checkMeshes(cut ? cut->scene : scene)) {
        problem.line = lineAt(root, problem.pointer);
        addProblem(problems, std::move(problem));
    }
}

SceneReading finished(std::optional<Scene> scene, std::optional<SceneCut> cut, Problems problems, const std::string& name,
                      std::span<const std::string> overrides) {
    nameOrigins(problems, name, overrides);
    std::stable_sort(problems.begin(), problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    if (hasErrors(problems))
        scene.reset();
    return {std::move(scene), std::move(cut), std::move(problems)};
}

// Reads no more than is needed to detect that a file, or an endless pipe, is too long.
std::string wholeText(std::istream& stream) {
    std::string text;
    std::array<char, 65536> part{};
    while (text.size() <= longestJson) {
        stream.read(part.data(), part.size());
        if (stream.gcount() == 0)
            break;
        text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    }
    return text;
}

SceneReading unreadable(const std::string& name, std::string message, std::string remedy) {
    return {{}, {}, {{Severity::Error, name, 0, "", std::move(message), std::move(remedy)}}};
}

}  // namespace

Scene sceneOfTree(const JsonNode& root, const RecordFolder& folder, std::vector<Problem>& unread,
                  std::vector<Problem>& lost) {
    Scene scene = readScene(root, unread, lost);
    readRecords(scene, root, folder, lost);
    return scene;
}

const Field* sceneFieldAt(const std::string& pointer) {
    const Structure* structure = &sceneStructure();
    const Field* field = nullptr;
    for (std::size_t from = 1; from < pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', from), pointer.size());
        const bool isItem = field && (field->kind == FieldKind::List || field->kind == FieldKind::Map);
        if (field && hasChildren(*field))
            structure = &field->children.structure();
        field = isItem ? nullptr : findField(*structure, pointer.substr(from, end - from));
        if (!field && !isItem)
            return nullptr;
        from = end + 1;
    }
    return field;
}

SceneReading readSceneText(std::string_view text, const std::string& name, std::span<const std::string> overrides,
                           const RecordFolder& folder) {
    JsonReading json = readJson(text);
    Problems problems = std::move(json.problems);
    if (!json.root)
        return finished({}, {}, std::move(problems), name, overrides);
    applyOverrides(*json.root, overrides, problems);
    if (!bringUpToDate(*json.root, problems))
        return finished({}, {}, std::move(problems), name, overrides);
    Problems ofFields, lost;
    Scene scene = sceneOfTree(*json.root, folder, ofFields, lost);
    ofFields.insert(ofFields.end(), lost.begin(), lost.end());
    std::optional<SceneCut> cut;
    for (const Problem& problem : ofFields)
        addProblem(problems, problem);
    if (!isFull(problems))
        addSense(scene, *json.root, ofFields, problems, cut);
    return finished(std::move(scene), std::move(cut), std::move(problems), name, overrides);
}

SceneReading readSceneFile(const std::filesystem::path& path, std::span<const std::string> overrides) {
    const std::string name = path.string();
    if (const std::string special = specialFileAt(path); !special.empty())
        return unreadable(name, "this is " + special + ", not a scene file", "Give a scene file");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return unreadable(name, "the file cannot be opened: " + std::string(std::strerror(errno)),
                          "Check the name and that you may read it");
    return readSceneText(wholeText(file), name, overrides, path.parent_path());
}

}  // namespace keyblock
