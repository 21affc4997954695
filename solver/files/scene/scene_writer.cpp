// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene is written with the same table with which it is read. Each object is
// compared with a reference, either its defaults or the bolt type on which it is
// based, and only differences are written.
#include "solver/files/scene/bolt_library.h"
#include "solver/files/json/field_json.h"
#include "solver/files/json/json_text.h"
#include "solver/files/json/object_writer.h"
#include "solver/files/scene/record_file.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/sha256.h"
#include "solver/files/atomic_file.h"
#include "solver/scene/field.h"
#include "solver/scene/lookup.h"

#include <ostream>

namespace keyblock {

namespace {

// The type on which `type` is based, among those of the scene and the built-in ones; if there is none, a type with
// default values.
const BoltType& baseOf(const BoltType& type, const Scene& scene) {
    static const BoltType defaults;
    if (type.like.empty())
        return defaults;
    if (const BoltType* own = findBoltType(scene, type.like))
        return *own;
    const BoltType* builtIn = findBuiltInBoltType(type.like);
    return builtIn ? *builtIn : defaults;
}

// The differences from the base. Sources inherited together with their values are not repeated.
JsonNode boltTypeNode(BoltType type, BoltType base) {
    std::erase_if(type.sources, [&](const auto& entry) {
        const auto inherited = base.sources.find(entry.first);
        return inherited != base.sources.end() && inherited->second == entry.second;
    });
    base.sources.clear();
    return objectNode(boltTypeStructure(), &type, &base);
}

JsonObject ownBoltTypes(const Scene& scene) {
    JsonObject types;
    for (const BoltType& type : scene.boltTypes)
        if (!type.builtIn)
            types.push_back({type.name, boltTypeNode(type, baseOf(type, scene))});
    return types;
}

JsonNode sceneNode(const Scene& scene) {
    const Structure& structure = sceneStructure();
    JsonObject members;
    for (const Field& field : structure.fields) {
        const bool isTypes = field.key == "bolt_types";
        JsonObject types = isTypes ? ownBoltTypes(scene) : JsonObject{};
        if (isTypes && !types.empty())
            members.push_back({std::string(field.key), {std::move(types)}});
        else if (!isTypes && (field.required || !sameValue(field, &scene, structure.defaults)))
            members.push_back({std::string(field.key), fieldNode(field, &scene, structure.defaults)});
    }
    return {std::move(members)};
}

// Records from a file are omitted, because they will be read from that file again.
template <typename StandsIn>
Scene withoutRecords(Scene scene, StandsIn standsInFile) {
    for (Stage& stage : scene.stages)
        for (auto* acceleration : {&stage.baseAcceleration, &stage.bodyAcceleration})
            if (*acceleration && !(*acceleration)->file.empty() && standsInFile(**acceleration))
                (*acceleration)->record.clear();
    return scene;
}

}  // namespace

std::string sceneText(const Scene& scene) {
    return jsonText(sceneNode(withoutRecords(scene, [](const Acceleration&) { return true; })));
}

std::string wholeSceneText(const Scene& scene) { return jsonText(sceneNode(scene)); }

std::string sceneHash(const Scene& scene) { return sha256(wholeSceneText(scene)); }

void writeSceneFile(const std::filesystem::path& path, const Scene& scene) {
    const std::filesystem::path folder = path.parent_path();
    const Scene written = withoutRecords(scene, [&](const Acceleration& acceleration) {
        return readRecordFile(folder / acceleration.file).record == acceleration.record;
    });
    writeAtomically(path, [&](std::ostream& out) { out << wholeSceneText(written); });
}

}  // namespace keyblock
