// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// There is only one version so far. A change that breaks old scenes adds a step here
// that converts a tree of version n to version n + 1.
#include "solver/files/scene/scene_version.h"

#include "solver/files/json/field_json.h"
#include "solver/files/json/json_text.h"

#include <string>

namespace keyblock {

namespace {

bool checkFormat(const JsonNode& format, std::vector<Problem>& problems) {
    const auto* text = std::get_if<std::string>(&format.value);
    if (text && *text == "keyblock-scene")
        return true;
    addError(problems, format, "/format", "this is not a Keyblock scene: 'format' is not \"keyblock-scene\"",
             "Give a scene file, or write \"format\": \"keyblock-scene\"");
    return false;
}

bool checkVersion(const JsonNode& version, std::vector<Problem>& problems) {
    const auto* number = std::get_if<double>(&version.value);
    if (number && *number == sceneVersion)
        return true;
    const std::string newest = std::to_string(sceneVersion);
    if (number && *number > sceneVersion)
        addError(problems, version, "/version",
                 "the scene has version " + jsonLine(version) + ", which is newer than this program reads, " + newest,
                 "Use a newer version of Keyblock");
    else
        addError(problems, version, "/version", "the scene format has no such version",
                 "Write \"version\": " + newest);
    return false;
}

}  // namespace

bool bringUpToDate(JsonNode& root, std::vector<Problem>& problems) {
    if (!std::holds_alternative<JsonObject>(root.value)) {
        addError(problems, root, "", "this is " + std::string(kindText(root)) + ", but a scene is an object",
                 "Write { \"format\": \"keyblock-scene\", … }");
        return false;
    }
    const JsonNode* format = findMember(root, "format");
    if (format && !checkFormat(*format, problems))
        return false;
    const JsonNode* version = findMember(root, "version");
    return !version || checkVersion(*version, problems);
}

}  // namespace keyblock
