// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/case_result.h"

#include "solver/files/atomic_file.h"
#include "solver/files/read_error.h"
#include "solver/files/text_file.h"
#include "solver/study/study_fields.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

namespace fs = std::filesystem;
using SummaryJson = nlohmann::ordered_json;

constexpr std::array<std::string_view, 6> outcomeWords{"done",  "invalid",   "numerical-failure",
                                                       "limit", "undecided", "error"};
constexpr std::uint64_t mostBytes = std::uint64_t{16} << 20;

template <typename T>
SummaryJson orNull(const std::optional<T>& value) {
    return value ? SummaryJson(*value) : SummaryJson();
}

template <typename T>
std::optional<T> optionalOf(const SummaryJson& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<T>());
}

SummaryJson valueJson(const std::string& quantity, const Measurement& value) {
    const bool finite = value.value && std::isfinite(*value.value);
    SummaryJson json{{"quantity", quantity}, {"value", finite ? SummaryJson(*value.value) : SummaryJson()}};
    if (!value.problem.empty()) json["problem"] = value.problem;
    if (!value.order.empty()) json["order"] = value.order;
    return json;
}

Measurement valueOf(const SummaryJson& json) {
    Measurement value;
    value.value = optionalOf<double>(json.at("value"));
    value.problem = json.value("problem", "");
    value.order = json.value("order", std::vector<std::string>{});
    return value;
}

SummaryJson faultJson(const BoltFault& fault) {
    SummaryJson json{
        {"fault", fault.fault}, {"bolt", fault.bolt}, {"kind", faultKindWords[static_cast<std::size_t>(fault.kind)]}};
    if (fault.kind == FaultKind::BondLost) json.update({{"from_m", fault.from}, {"to_m", fault.to}});
    if (fault.kind == FaultKind::Misplaced) json.update({{"offset_m", fault.offset}, {"angle_deg", fault.angle}});
    return json;
}

}  // namespace

std::string_view wordOf(CaseOutcome outcome) { return outcomeWords[static_cast<std::size_t>(outcome)]; }

void writeCaseResult(const fs::path& file, const SweepCaseResult& result, const std::string& sweep,
                     const std::vector<std::string>& quantities) {
    SummaryJson values = SummaryJson::array(), faults = SummaryJson::array();
    for (std::size_t i = 0; i < quantities.size() && i < result.values.size(); ++i)
        values.push_back(valueJson(quantities[i], result.values[i]));
    for (const BoltFault& fault : result.faults) faults.push_back(faultJson(fault));
    const SummaryJson json{{"sweep", sweep},
                           {"case", result.number},
                           {"outcome", wordOf(result.outcome)},
                           {"reason", result.reason},
                           {"stands", orNull(result.stands)},
                           {"fails", orNull(result.fails)},
                           {"values", values},
                           {"factor_of_safety", {orNull(result.safetyLower), orNull(result.safetyUpper)}},
                           {"fault_measures", result.faultMeasures},
                           {"faults", faults},
                           {"steps", result.steps},
                           {"cpu_s", result.cpuSeconds},
                           {"wall_s", result.wallSeconds},
                           {"host", result.host}};
    // text that is not UTF-8, such as a host name, must not lose the case
    const std::string text = json.dump(1, ' ', false, SummaryJson::error_handler_t::replace) + "\n";
    writeAtomically(file, [&](std::ostream& out) { out << text; });
}

std::optional<SweepCaseResult> readCaseResult(const fs::path& file, const std::string& sweep, std::size_t quantities) {
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    const std::string text = readTextFile(file, {mostBytes, "give a case", "delete it and run the case again"});
    const auto fail = [&](const std::string& why) {
        throw CannotRead("cannot read " + file.string() + ": " + why + "; delete it and run the case again");
    };
    SweepCaseResult result;
    try {
        const SummaryJson json = SummaryJson::parse(text);
        if (json.at("sweep") != sweep) fail("it belongs to another plan");
        json.at("case").get_to(result.number);
        const std::string word = json.at("outcome");
        const auto found = std::find(outcomeWords.begin(), outcomeWords.end(), word);
        if (found == outcomeWords.end()) fail("it is damaged");
        result.outcome = static_cast<CaseOutcome>(found - outcomeWords.begin());
        json.at("reason").get_to(result.reason);
        result.stands = optionalOf<bool>(json.at("stands"));
        result.fails = optionalOf<bool>(json.at("fails"));
        for (const SummaryJson& value : json.at("values")) result.values.push_back(valueOf(value));
        result.safetyLower = optionalOf<double>(json.at("factor_of_safety").at(0));
        result.safetyUpper = optionalOf<double>(json.at("factor_of_safety").at(1));
        json.at("fault_measures").get_to(result.faultMeasures);
        json.at("steps").get_to(result.steps);
        json.at("cpu_s").get_to(result.cpuSeconds);
        json.at("wall_s").get_to(result.wallSeconds);
        json.at("host").get_to(result.host);
    } catch (const SummaryJson::exception&) {
        fail("it is damaged");
    }
    if (!result.values.empty() && result.values.size() != quantities) fail("it is damaged");
    return result;
}

}  // namespace keyblock
