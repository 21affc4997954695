// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `bolts`: lists the bolt library, or one type with the source of every
// number.
#include "app/cli/bolt_listing.h"
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "app/cli/text_table.h"
#include "solver/files/scene/bolt_library.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/units.h"

namespace keyblock::cli {

namespace {

std::string classWord(const BoltType& type) {
    return std::string(boltClassWords[static_cast<std::size_t>(type.boltClass)]);
}

std::string kilonewtons(double force) { return shown(fromSi(force, namedUnit("kN"))); }

TextRow overviewRow(const BoltType& type) {
    const BoltSteel steel = boltSteel(type);
    const std::optional<double>& plate = type.plate.normalStrength;
    return {type.name,
            classWord(type),
            shown(fromSi(type.diameter, namedUnit("mm"))),
            shown(fromSi(steel.area, *readUnit("mm²"))),
            steel.tensile ? kilonewtons(*steel.tensile) : "unlimited",
            steel.tensile ? kilonewtons(*steel.tensile * type.shearStrengthRatio) : "unlimited",
            plate ? kilonewtons(*plate) : "unlimited"};
}

std::string overview() {
    std::vector<TextRow> rows;
    for (const BoltType& type : builtInBoltTypes())
        rows.push_back(overviewRow(type));
    return textTable({{"type"},
                      {"class"},
                      {"diameter, mm", Align::Right},
                      {"area, mm²", Align::Right},
                      {"tension, kN", Align::Right},
                      {"shear, kN", Align::Right},
                      {"plate, kN", Align::Right}},
                     rows) +
           "\nAll values are per bolt. 'keyblock bolts NAME' lists every number of a type with its source.\n";
}

std::string typeNames() {
    std::string names;
    for (const BoltType& type : builtInBoltTypes())
        names += (names.empty() ? "" : ", ") + type.name;
    return names;
}

std::string detail(const BoltType& type) {
    std::vector<TextRow> rows;
    bool allConfirmed = true;
    for (const BoltNumber& number : numbersOf(type)) {
        rows.push_back({number.key, number.value, number.unit, number.confirmed ? "" : "?", number.source});
        allConfirmed = allConfirmed && number.confirmed;
    }
    const std::string origin = type.like.empty() ? "" : ", like " + type.like;
    return type.name + " (" + classWord(type) + origin + ")\n" +
           (type.source.empty() ? "" : type.source + "\n") + "\n" +
           textTable({{"key"}, {"value", Align::Right}, {"unit"}, {""}, {"source"}}, rows) +
           (allConfirmed ? "" : "\n? marks a number that no available source confirms.\n");
}

}  // namespace

ExitCode perform(const BoltsOptions& options) {
    if (!options.name) {
        print(overview());
        return Done;
    }
    const BoltType* type = findBuiltInBoltType(*options.name);
    if (!type)
        throw UsageError("there is no bolt type '" + *options.name + "'; there are " + typeNames());
    print(detail(*type));
    return Done;
}

}  // namespace keyblock::cli
