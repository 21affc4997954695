// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/factored_links.h"

#include "solver/engine/step/link_keys.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr double equalWeight = 1e-9;  // relative difference up to which two weights are equal
constexpr double sameWeight = 1e-2;  // relative change of weight up to which a link keeps its weight in the factor
constexpr double sameGradient = 1e-4;  // squared relative change of gradient beyond which a link is replaced

FactoredLink asNow(const LinkRows& rows, std::size_t i, double weight) {
    FactoredLink link{weight, rows.firstOfA(i), rows.firstOfB(i), {}};
    std::copy_n(rows.gradient(i), 12, link.gradient.begin());
    return link;
}

/// Difference of two weights, as a fraction of the larger one.
double off(double a, double b) {
    const double larger = std::max(a, b);
    return larger > 0.0 ? std::abs(a - b) / larger : 0.0;
}

/// True if the gradient of a link differs from that in the factor by more than may be left.
bool isTurned(const FactoredLink& link, const LinkRows& rows, std::size_t i) {
    double turned = 0.0, size = 0.0;
    for (std::size_t k = 0; k < 12; ++k) {
        const double g = rows.gradient(i)[k], off = g - link.gradient[k];
        turned += off * off;
        size += g * g;
    }
    return !(turned <= sameGradient * size);
}

}  // namespace

bool FactoredLinks::begin(const StepProblem& problem, const LinkRows& rows) {
    std::vector<std::uint64_t> keys;
    keys.reserve(problem.links.size());
    for (const Link& link : problem.links) keys.push_back(keyOf(link));
    const bool same = keys == keys_;
    if (!same) matchLinks(std::move(keys));
    turned_.resize(links_.size());
    for (std::size_t i = 0; i < links_.size(); ++i) turned_[i] = links_[i].weight > 0.0 && isTurned(links_[i], rows, i);
    return same;
}

void FactoredLinks::matchLinks(std::vector<std::uint64_t> keys) {
    std::vector<FactoredLink> links(keys.size());
    const auto take = [&](std::size_t before, std::size_t now) { links[now] = links_[before]; };
    const auto [before, now] = alignRows(keys_, keys, take);
    auto next = now.begin();
    for (const auto& [key, row] : before) {
        while (next != now.end() && next->first < key) ++next;
        const FactoredLink& link = links_[row];
        if (next != now.end() && next->first == key) links[(next++)->second] = link;
        else if (link.weight > 0.0) ended_.push_back(link);
    }
    links_ = std::move(links);
    keys_ = std::move(keys);
}

bool FactoredLinks::isAsNow(std::size_t i, double weight) const {
    return off(weight, links_[i].weight) <= sameWeight && (weight == 0.0 || !turned_[i]);
}

FactoredLinks::Changes FactoredLinks::changesTo(const LinkRows& rows, std::span<const double> weights) const {
    Changes changes;
    changes.take = ended_;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (isAsNow(i, weights[i])) {
            changes.rounded = changes.rounded || off(links_[i].weight, weights[i]) > equalWeight;
            continue;
        }
        if (links_[i].weight > 0.0) changes.take.push_back(links_[i]);
        if (weights[i] > 0.0) changes.add.push_back(asNow(rows, i, weights[i]));
    }
    return changes;
}

void FactoredLinks::change(const LinkRows& rows, std::span<const double> weights) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (isAsNow(i, weights[i])) continue;
        links_[i] = asNow(rows, i, weights[i]);
        turned_[i] = 0;
    }
    ended_.clear();
}

void FactoredLinks::renew(const LinkRows& rows, std::span<const double> weights) {
    for (std::size_t i = 0; i < weights.size(); ++i) links_[i] = asNow(rows, i, weights[i]);
    turned_.assign(links_.size(), 0);
    ended_.clear();
}

}  // namespace keyblock
