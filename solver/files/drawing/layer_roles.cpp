// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/drawing/layer_roles.h"

#include "solver/files/drawing/dxf_entities.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 5> roleWords{"joint", "boundary", "tunnel", "bolt", "ignore"};

/// Part of a layer name that indicates a role; the first part found decides.
struct Sign {
    std::string_view part;
    LayerRole role;
};

constexpr std::array<Sign, 45> signs{{
    {"defpoints", LayerRole::Ignore}, {"text", LayerRole::Ignore},      {"annot", LayerRole::Ignore},
    {"dim", LayerRole::Ignore},       {"hatch", LayerRole::Ignore},     {"title", LayerRole::Ignore},
    {"legend", LayerRole::Ignore},    {"grid", LayerRole::Ignore},      {"axis", LayerRole::Ignore},
    {"note", LayerRole::Ignore},      {"viewport", LayerRole::Ignore},  {"bolt", LayerRole::Bolt},
    {"anchor", LayerRole::Bolt},      {"anker", LayerRole::Bolt},       {"dowel", LayerRole::Bolt},
    {"nagel", LayerRole::Bolt},       {"boulon", LayerRole::Bolt},      {"perno", LayerRole::Bolt},
    {"tunnel", LayerRole::Tunnel},    {"drift", LayerRole::Tunnel},     {"excav", LayerRole::Tunnel},
    {"opening", LayerRole::Tunnel},   {"heading", LayerRole::Tunnel},   {"profil", LayerRole::Tunnel},
    {"cavern", LayerRole::Tunnel},    {"stope", LayerRole::Tunnel},     {"adit", LayerRole::Tunnel},
    {"gallery", LayerRole::Tunnel},   {"stollen", LayerRole::Tunnel},   {"bound", LayerRole::Boundary},
    {"border", LayerRole::Boundary},  {"outline", LayerRole::Boundary}, {"domain", LayerRole::Boundary},
    {"extent", LayerRole::Boundary},  {"limit", LayerRole::Boundary},   {"rand", LayerRole::Boundary},
    {"joint", LayerRole::Joint},      {"fault", LayerRole::Joint},      {"fract", LayerRole::Joint},
    {"crack", LayerRole::Joint},      {"bedding", LayerRole::Joint},    {"discont", LayerRole::Joint},
    {"kluft", LayerRole::Joint},      {"trace", LayerRole::Joint},      {"foliation", LayerRole::Joint}}};

std::optional<LayerRole> givenRole(const ImportSettings& settings, std::string_view layer) {
    for (const auto& [name, role] : settings.roles)
        if (lowerCase(name) == lowerCase(layer)) return role;
    return std::nullopt;
}

void checkGivenLayers(const ImportSettings& settings, const std::map<std::string, std::string>& layers,
                      std::vector<Problem>& problems) {
    std::vector<std::string_view> names;
    for (const auto& [key, name] : layers) names.push_back(name);
    for (const auto& [name, role] : settings.roles)
        if (name != "*" && !layers.contains(lowerCase(name)))
            problems.push_back({Severity::Error, "", 0, "",
                                "no layer named " + inQuotes(name) + " contains entities",
                                names.empty() ? "No layer does" : suggestion(name, names)});
}

void tellUnknown(const std::vector<std::string_view>& unknown, std::vector<Problem>& problems) {
    if (unknown.empty()) return;
    problems.push_back({Severity::Error, "", 0, "",
                        "the names of these layers do not show their role: " + listed(unknown),
                        "Give --role LAYER=joint|boundary|tunnel|bolt|ignore for each of them; '*=ignore' ignores all "
                        "others"});
}

}  // namespace

std::string_view wordOf(LayerRole role) { return roleWords[static_cast<std::size_t>(role)]; }

std::optional<LayerRole> layerRoleOf(std::string_view word) {
    const auto found = std::find(roleWords.begin(), roleWords.end(), word);
    if (found == roleWords.end()) return std::nullopt;
    return static_cast<LayerRole>(found - roleWords.begin());
}

std::optional<LayerRole> guessedRole(std::string_view layer) {
    const std::string name = lowerCase(layer);
    for (const Sign& sign : signs)
        if (name.find(sign.part) != std::string::npos) return sign.role;
    return std::nullopt;
}

std::vector<ImportedLayer> layerRoles(const Drawing& drawing, const ImportSettings& settings,
                                      std::vector<Problem>& problems) {
    std::map<std::string, std::string> layers, all;  // by name in lower case
    for (const DrawnLine& line : drawing.lines) layers.emplace(lowerCase(line.layer), line.layer);
    all = layers;
    for (const NotTaken& item : drawing.notTaken) all.emplace(lowerCase(item.layer), item.layer);
    checkGivenLayers(settings, all, problems);
    const std::set<std::string> hidden(drawing.hiddenLayers.begin(), drawing.hiddenLayers.end());
    std::vector<ImportedLayer> roles;
    std::vector<std::string_view> unknown;
    for (const auto& [key, name] : layers) {
        const std::optional<LayerRole> given = givenRole(settings, name), rest = givenRole(settings, "*");
        if (given)
            roles.push_back({name, *given, true, "given"});
        else if (hidden.contains(key))
            roles.push_back({name, LayerRole::Ignore, true, "frozen or off"});
        else if (const std::optional<LayerRole> guess = guessedRole(name))
            roles.push_back({name, *guess, true, "guessed from its name"});
        else
            roles.push_back({name, rest.value_or(LayerRole::Ignore), rest.has_value(),
                             rest ? "given for all others" : "not known"});
        if (!roles.back().known) unknown.push_back(name);
    }
    tellUnknown(unknown, problems);
    return roles;
}

}  // namespace keyblock
