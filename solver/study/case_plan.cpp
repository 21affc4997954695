// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/case_plan.h"

#include "geometry/random.h"
#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/scene/number_text.h"
#include "solver/study/distributions.h"
#include "solver/study/study_fields.h"

#include <algorithm>
#include <numeric>

namespace keyblock {

namespace {

enum Purpose : std::int64_t { Value, Stratum, SeedValue };

long levelsOf(const StudyParameter& parameter) {
    if (parameter.range) return parameter.range->count;
    return parameter.distribution ? 1 : static_cast<long>(parameter.values.size());
}

std::string levelText(const StudyParameter& parameter, long level) {
    if (!parameter.range) return cellOf(parameter.values[level]);
    const StudyRange& range = *parameter.range;
    const double share = static_cast<double>(level) / (range.count - 1);
    return shortest(level == range.count - 1 ? range.to : range.from + share * (range.to - range.from));
}

/// A random order of 0 … count − 1 (Fisher and Yates).
std::vector<std::uint32_t> shuffled(std::uint32_t count, Random random) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    for (std::uint32_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.bits() % i]);
    return order;
}

}  // namespace

std::int64_t streamOf(std::string_view name) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return static_cast<std::int64_t>(hash);
}

long combinationsOf(const Study& study) {
    long count = 1;
    for (const StudyParameter& parameter : study.parameters) {
        count *= levelsOf(parameter);
        if (count > mostCases) return mostCases + 1;
    }
    return count;
}

CasePlan::CasePlan(const Study& study) : study_(study) {
    const bool factorial = study.plan.kind == PlanKind::FullFactorial;
    cases_ = factorial ? combinationsOf(study) : study.plan.cases.value_or(1);
    if (study.plan.kind != PlanKind::LatinHypercube) return;
    for (const StudyParameter& parameter : study.parameters)
        strata_.push_back(
            shuffled(static_cast<std::uint32_t>(cases_), Random(study.plan.seed, {Stratum, streamOf(parameter.name)})));
}

std::vector<std::string> CasePlan::row(long number) const {
    std::vector<std::string> cells;
    for (std::size_t p = 0; p < study_.parameters.size(); ++p) cells.push_back(cell(p, number - 1));
    return cells;
}

/// Number above 0 and below 1 from which the value of a parameter follows.
double CasePlan::position(std::size_t parameter, long index) const {
    Random random(study_.plan.seed, {Value, streamOf(study_.parameters[parameter].name), index});
    const double within = random.uniform() + 0x1p-54;
    if (strata_.empty()) return within;
    return (static_cast<double>(strata_[parameter][index]) + within) / static_cast<double>(cases_);
}

std::string CasePlan::cell(std::size_t p, long index) const {
    const StudyParameter& parameter = study_.parameters[p];
    constexpr std::uint64_t seeds = 2'000'000'000;
    if (parameter.distribution && parameter.distribution->kind == DistributionKind::Seed)
        return std::to_string(1 +
                              Random(study_.plan.seed, {SeedValue, streamOf(parameter.name), index}).bits() % seeds);
    if (parameter.distribution) return shortest(quantileOf(*parameter.distribution, position(p, index)));
    const long levels = levelsOf(parameter);
    if (study_.plan.kind != PlanKind::FullFactorial)
        return levelText(parameter,
                         std::min(levels - 1, static_cast<long>(position(p, index) * static_cast<double>(levels))));
    long later = 1;  // combinations of the parameters that follow, which change faster
    for (std::size_t next = p + 1; next < study_.parameters.size(); ++next) later *= levelsOf(study_.parameters[next]);
    return levelText(parameter, index / later % levels);
}

std::string cellOf(const std::string& jsonValue) {
    const JsonReading value = readJson(jsonValue);
    const auto* text = value.root ? std::get_if<std::string>(&value.root->value) : nullptr;
    return text ? *text : jsonValue;
}

std::vector<std::string> overridesOf(const Study& study, const std::vector<std::string>& row) {
    std::vector<std::string> overrides;
    for (std::size_t p = 0; p < study.parameters.size(); ++p) {
        const StudyParameter& parameter = study.parameters[p];
        const auto listed = std::find_if(parameter.values.begin(), parameter.values.end(),
                                         [&](const std::string& value) { return cellOf(value) == row[p]; });
        const std::string value = listed == parameter.values.end() ? row[p] : *listed;
        const bool isSeed = parameter.distribution && parameter.distribution->kind == DistributionKind::Seed;
        overrides.push_back(parameter.path + "=" + value);
        for (std::size_t i = 0; i < parameter.also.size(); ++i)
            overrides.push_back(parameter.also[i] + "=" +
                                (isSeed ? std::to_string(std::stol(value) + static_cast<long>(i) + 1) : value));
    }
    return overrides;
}

}  // namespace keyblock
