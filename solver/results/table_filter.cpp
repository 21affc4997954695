// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A requested time need not be a stored one: the nearest stored time is used, and the
// table gives it in `time_s`.
#include "solver/results/table_filter.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace keyblock {

namespace {

template <typename Named>
std::string names(const std::vector<Named>& items) {
    std::string text;
    for (const Named& item : items)
        text += (text.empty() ? "" : ", ") + item.name;
    return text.empty() ? "none" : text;
}

template <typename Named>
std::optional<int> indexOf(const std::vector<Named>& items, const std::string& name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Named& item) { return item.name == name; });
    if (found == items.end())
        return std::nullopt;
    return static_cast<int>(found - items.begin());
}

std::optional<double> numberIn(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// Sets the stage of the filter.
/// \return an error message, or an empty string.
std::string readStage(const Scene& scene, const std::string& name, TableFilter& filter) {
    const std::optional<int> stage = indexOf(scene.stages, name);
    if (!stage)
        return "no stage is named '" + name + "'; there are: " + names(scene.stages);
    if (filter.stage && *filter.stage != *stage)
        return "--stage and --at name different stages; omit one";
    filter.stage = stage;
    return {};
}

/// Sets the time of the filter.
/// \return an error message, or an empty string.
std::string readMoment(const Scene& scene, const std::string& at, TableFilter& filter) {
    if (at == "last" || at == "all") {
        filter.when = at == "last" ? When::Last : When::All;
        return {};
    }
    const auto colon = at.rfind(':');
    const auto time = colon == std::string::npos ? std::nullopt : numberIn(at.substr(colon + 1));
    if (!time)
        return "'" + at + "' is not a time; write STAGE:TIME (as in 'pull:0.5'), last or all";
    filter.when = When::At;
    filter.time = *time;
    return readStage(scene, at.substr(0, colon), filter);
}

double distance(const RowMoment& moment, const TableFilter& filter) { return std::abs(moment.time - filter.time); }

}  // namespace

TableFilterReading readTableFilter(const Scene& scene, const std::optional<std::string>& stage,
                                   const std::optional<std::string>& bolt, const std::optional<std::string>& at) {
    TableFilter filter;
    std::string problem;
    if (stage)
        problem = readStage(scene, *stage, filter);
    if (problem.empty() && at)
        problem = readMoment(scene, *at, filter);
    if (problem.empty() && bolt) {
        filter.bolt = indexOf(scene.bolts, *bolt);
        if (!filter.bolt)
            problem = "no bolt is named '" + *bolt + "'; there are: " + names(scene.bolts);
    }
    if (!problem.empty())
        return {{}, problem};
    return {filter, ""};
}

std::vector<std::size_t> selected(const std::vector<RowMoment>& moments, const TableFilter& filter, When byDefault) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < moments.size(); ++i)
        if (!filter.stage || moments[i].stage == *filter.stage)
            indices.push_back(i);
    const When when = filter.when.value_or(byDefault);
    if (when == When::All || indices.empty())
        return indices;
    std::size_t wanted = indices.back();
    if (when == When::At)
        wanted = *std::min_element(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
            return distance(moments[a], filter) < distance(moments[b], filter);
        });
    std::erase_if(indices, [&](std::size_t i) {
        return moments[i].stage != moments[wanted].stage || moments[i].time != moments[wanted].time;
    });
    return indices;
}

}  // namespace keyblock
