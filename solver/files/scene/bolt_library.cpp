// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of the library have the same form as `bolt_types` in a scene and are read
// by the same code. An error in them is an error in the program, which its tests
// detect.
#include "solver/files/scene/bolt_library.h"

#include "solver/files/scene/bolt_library_texts.h"
#include "solver/files/scene/bolt_type_reader.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace keyblock {

namespace {

void refuseProblems(const std::vector<Problem>& problems) {
    if (!problems.empty())
        throw std::logic_error("the built-in bolt library is invalid: " + oneLine(problems.front()));
}

JsonNode allTypes() {
    JsonObject types;
    for (const std::string_view text : boltLibraryTexts()) {
        JsonReading reading = readJson(text);
        refuseProblems(reading.problems);
        auto& members = std::get<JsonObject>(reading.root->value);
        std::move(members.begin(), members.end(), std::back_inserter(types));
    }
    return {std::move(types)};
}

std::vector<BoltType> readLibrary() {
    std::vector<Problem> problems;
    std::vector<BoltType> types = readBoltTypes(allTypes(), {}, "", problems);
    refuseProblems(problems);
    for (BoltType& type : types)
        type.builtIn = true;
    std::sort(types.begin(), types.end(), [](const BoltType& a, const BoltType& b) { return a.name < b.name; });
    return types;
}

}  // namespace

const std::vector<BoltType>& builtInBoltTypes() {
    static const std::vector<BoltType> types = readLibrary();
    return types;
}

const BoltType* findBuiltInBoltType(std::string_view name) {
    const auto& types = builtInBoltTypes();
    const auto found =
        std::find_if(types.begin(), types.end(), [&](const BoltType& type) { return type.name == name; });
    return found == types.end() ? nullptr : &*found;
}

void addUsedBuiltInBoltTypes(Scene& scene) {
    const auto add = [&](const std::string& name) {
        const BoltType* type = findBuiltInBoltType(name);
        if (type && !findBoltType(scene, name))
            scene.boltTypes.push_back(*type);
    };
    for (const Bolt& bolt : scene.bolts)
        add(bolt.type);
    for (const ScenePattern& pattern : scene.boltPatterns)
        add(pattern.type);
}

}  // namespace keyblock
