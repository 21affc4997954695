// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/path_review.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/springs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keyblock {
namespace {

// rotation of a block [rad]: the arc of a corner deviates from its chord by 0.25 % of its length
constexpr double mostTurn = 0.02;
constexpr double mostUncertain = 0.05;  // uncertain shear forces, as a fraction of the sum of the contact forces
constexpr double mostLengthChange = 0.25;  // as a fraction of the largest tributary length of the bolt's nodes
constexpr double faintForce = 1e-4;  // fraction of the largest contact force: contacts that carry less are ignored

/// Behaviour of a contact in its last increment.
struct Behaviour {
    const Contact* contact = nullptr;
    bool carries = false;
    int slides = 0;  // −1 or 1: direction of sliding; 0: no sliding
};

Behaviour behaviourOf(const Contact& c) {
    const bool carries = c.bonded || c.normalForce > 0.0;
    return {&c, carries, !carries || c.slid == 0.0 ? 0 : c.slid > 0.0 ? 1 : -1};
}

double forceOf(const Behaviour& behaviour) { return behaviour.contact ? behaviour.contact->normalForce : 0.0; }

using Features = std::array<int, 4>;

Features featuresOf(const Contact& c) { return {c.blockA, c.corner, c.blockB, c.edge}; }

double largestForce(const State& state) {
    double largest = 0.0;
    for (const Contact& c : state.contacts) largest = std::max(largest, std::abs(c.normalForce));
    return largest;
}

/// Uncertainty of the shear force of a contact that slid in the previous increment and no longer slides in that
/// direction: it may still have slid during part of this increment.
double uncertainShear(const Model& model, const Contact& before, double ratio) {
    return std::min(contactSprings(model, before).shear * std::abs(before.slid) * ratio, 2.0 * before.limit);
}

void reviewContacts(const Model& model, const State& before, const State& after, double ratio, PathReview& review) {
    const double largest = std::max(largestForce(before), largestForce(after));
    double uncertain = 0.0, all = 0.0;
    std::map<Features, Behaviour> first;
    for (const Contact& c : before.contacts) first.emplace(featuresOf(c), behaviourOf(c));
    const auto compare = [&](const Behaviour& b, const Behaviour& a) {
        const double force = std::max(forceOf(b), forceOf(a));
        if (force <= faintForce * largest) return;
        const bool stops = ratio > 0.0 && b.slides != 0 && a.slides != b.slides;
        if (b.carries != a.carries || (a.slides != 0 && a.slides != b.slides) || stops) review.straight = false;
        if (stops) uncertain += uncertainShear(model, *b.contact, ratio);
        all += force;
    };
    for (const Contact& c : after.contacts) {
        const auto same = first.find(featuresOf(c));
        compare(same == first.end() ? Behaviour{} : same->second, behaviourOf(c));
        if (same != first.end()) first.erase(same);
    }
    for (const auto& [features, behaviour] : first) compare(behaviour, {});
    if (all > 0.0) review.error = std::max(review.error, uncertain / (mostUncertain * all));
}

bool sameNode(const BoltNode& a, const BoltNode& b) {
    return a.slot == b.slot && a.bond.bonded == b.bond.bonded && a.bond.gone == b.bond.gone &&
           a.bond.sliding == b.bond.sliding && a.bond.curve == b.bond.curve && a.normalOffset == b.normalOffset;
}

bool sameSteel(const BoltElementState& a, const BoltElementState& b) {
    return a.steel == b.steel && a.hingeBend == b.hingeBend && a.hingeSway == b.hingeSway && a.ruptured == b.ruptured;
}

/// Largest change of tributary length among the nodes that stay in their block, over the largest tributary length.
double lengthChange(const BoltMotion& before, const BoltMotion& after) {
    double change = 0.0, largest = 0.0;
    for (std::size_t n = 0; n < before.nodes.size(); ++n) {
        const BoltNode &b = before.nodes[n], &a = after.nodes[n];
        largest = std::max(largest, b.normalShare);
        if (b.slot == a.slot) change = std::max(change, std::abs(a.normalShare - b.normalShare));
    }
    return largest > 0.0 ? change / largest : 0.0;
}

void reviewBolts(const Model& model, const State& before, const State& after, PathReview& review) {
    State followed = after;  // with updated blocks and tributary lengths of the nodes
    followBolts(model, followed);
    for (std::size_t b = 0; b < before.bolts.size(); ++b) {
        const BoltMotion &first = before.bolts[b], &last = followed.bolts[b];
        if (!acts(first) || !acts(last)) continue;
        const bool same = std::equal(first.nodes.begin(), first.nodes.end(), last.nodes.begin(), sameNode) &&
                          std::equal(first.elements.begin(), first.elements.end(), last.elements.begin(), sameSteel);
        if (!same) review.boltsFlow = true;
        review.error = std::max(review.error, lengthChange(first, last) / mostLengthChange);
    }
    if (review.boltsFlow) review.straight = false;
}

}  // namespace

PathReview reviewPath(const Model& model, const State& before, const State& after, double ratio) {
    PathReview review;
    reviewContacts(model, before, after, ratio, review);
    if (!before.bolts.empty()) reviewBolts(model, before, after, review);
    for (std::size_t i = 0; i < before.blocks.size(); ++i)
        review.turn = std::max(review.turn, std::abs(after.blocks[i].angle - before.blocks[i].angle) / mostTurn);
    return review;
}

}  // namespace keyblock
