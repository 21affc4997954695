// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/anchor_edit.h"

#include "solver/files/scene/bolt_library.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr int usualDivisions = 60;

double toleranceOf(const std::vector<double>& nodes) { return 1e-6 * nodes.back(); }

std::size_t nearestNode(const std::vector<double>& nodes, double s) {
    const auto nearest = std::ranges::min_element(nodes, {}, [&](double node) { return std::abs(node - s); });
    return nearest - nodes.begin();
}

/// First and last node of an entry; first > last for an interval between two nodes.
struct Span {
    std::size_t first = 1, last = 0;
    bool holds(std::size_t node) const { return first <= node && node <= last; }
};

Span nodesIn(double from, double to, const std::vector<double>& nodes) {
    Span span{nodes.size(), 0};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i] < from - toleranceOf(nodes) || nodes[i] > to + toleranceOf(nodes)) continue;
        span.first = std::min(span.first, i);
        span.last = i;
    }
    return span;
}

Span spanOf(const Anchor& anchor, const std::vector<double>& nodes) {
    const double length = nodes.back();
    if (anchor.at) {
        const std::size_t node = nearestNode(nodes, distanceAlong(*anchor.at, length));
        return {node, node};
    }
    const double from = distanceAlong(anchor.from, length), to = distanceAlong(anchor.to, length);
    const Span span = nodesIn(from, to, nodes);
    if (span.first <= span.last) return span;
    const std::size_t node = nearestNode(nodes, 0.5 * (from + to));  // for an interval between two nodes
    return {node, node};
}

double halfBefore(const std::vector<double>& nodes, std::size_t i) {
    return i == 0 ? nodes.front() : 0.5 * (nodes[i - 1] + nodes[i]);
}

double halfAfter(const std::vector<double>& nodes, std::size_t i) {
    return i + 1 == nodes.size() ? nodes.back() : 0.5 * (nodes[i] + nodes[i + 1]);
}

BoltPlace placeAt(double s, double length) { return s >= length ? BoltPlace{true, 0.0} : BoltPlace{false, s}; }

/// Adds the parts of a range on both sides of the removed nodes.
void addParts(std::vector<Anchor>& kept, const Anchor& anchor, const std::vector<double>& nodes, std::size_t first,
              std::size_t last) {
    const double length = nodes.back();
    const double from = distanceAlong(anchor.from, length), to = distanceAlong(anchor.to, length);
    const double before = halfBefore(nodes, first), after = halfAfter(nodes, last);
    if (const Span left = nodesIn(from, before, nodes); left.first < first && left.first <= left.last) {
        kept.push_back(anchor);
        kept.back().to = placeAt(before, length);
    }
    if (const Span right = nodesIn(after, to, nodes); right.last > last && right.first <= right.last) {
        kept.push_back(anchor);
        kept.back().from = placeAt(after, length);
    }
}

std::vector<Anchor> without(const std::vector<Anchor>& anchors, const std::vector<double>& nodes, std::size_t first,
                            std::size_t last) {
    std::vector<Anchor> kept;
    for (const Anchor& anchor : anchors) {
        const Span span = spanOf(anchor, nodes);
        if (span.last < first || span.first > last)
            kept.push_back(anchor);
        else if (!anchor.at)
            addParts(kept, anchor, nodes, first, last);
    }
    return kept;
}

/// The entry whose nodes are nearest.
const Anchor& nearestEntry(const std::vector<Anchor>& anchors, const std::vector<double>& nodes, std::size_t node,
                           const Anchor& otherwise) {
    const Anchor* nearest = &otherwise;
    std::size_t least = nodes.size();
    for (const Anchor& anchor : anchors) {
        const Span span = spanOf(anchor, nodes);
        const std::size_t apart = span.holds(node) ? 0 : node < span.first ? span.first - node : node - span.last;
        if (apart < least) {
            least = apart;
            nearest = &anchor;
        }
    }
    return *nearest;
}

}  // namespace

std::vector<bool> realNodes(const std::vector<Anchor>& anchors, const std::vector<double>& nodes) {
    std::vector<bool> real(nodes.size(), false);
    for (const Anchor& anchor : anchors) {
        const Span span = spanOf(anchor, nodes);
        for (std::size_t i = span.first; i <= span.last; ++i) real[i] = true;
    }
    return real;
}

std::vector<Anchor> withNodes(std::vector<Anchor> anchors, const std::vector<double>& nodes, std::size_t first,
                              std::size_t last, bool real, const Anchor& pattern) {
    if (!real) return without(anchors, nodes, first, last);
    const std::vector<bool> held = realNodes(anchors, nodes);
    const Anchor entry = nearestEntry(anchors, nodes, first, pattern);
    for (std::size_t i = first; i <= last;) {
        if (held[i]) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (!entry.at && end < last && !held[end + 1]) ++end;
        Anchor made = entry;
        if (entry.at) {
            made.at = placeAt(nodes[i], nodes.back());
        } else {
            made.from = {false, halfBefore(nodes, i)};
            made.to = placeAt(halfAfter(nodes, end), nodes.back());
        }
        anchors.push_back(std::move(made));
        i = end + 1;
    }
    return anchors;
}

std::vector<double> evenNodes(double length, std::optional<int> divisions) {
    const int count = std::max(1, divisions.value_or(usualDivisions));
    std::vector<double> nodes;
    for (int i = 0; i <= count; ++i) nodes.push_back(length * i / count);
    return nodes;
}

const BoltType* boltTypeNamed(const Scene& scene, const std::string& name) {
    const BoltType* own = findBoltType(scene, name);
    return own ? own : findBuiltInBoltType(name);
}

std::vector<NodeAhead> nodesAhead(const Scene& scene, const std::string& type, double length,
                                  std::optional<int> divisions) {
    const BoltType* found = boltTypeNamed(scene, type);
    if (!found || !(length > 0.0) || !std::isfinite(length)) return {};
    const std::vector<double> nodes = evenNodes(length, divisions);
    const std::vector<bool> real = realNodes(found->anchors, nodes);
    std::vector<NodeAhead> ahead;
    for (std::size_t i = 0; i < nodes.size(); ++i) ahead.push_back({nodes[i] / length, real[i]});
    return ahead;
}

}  // namespace keyblock
