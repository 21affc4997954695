// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/marks.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

Point directionAt(const std::vector<Point>& nodes, std::size_t i) {
    const std::size_t from = i > 0 ? i - 1 : 0, to = std::min(i + 1, nodes.size() - 1);
    const Point along = nodes[to] - nodes[from];
    return along.norm() > 0.0 ? Point(along.normalized()) : Point(1.0, 0.0);
}

MarkKind kindOf(const BoltNodeFrame& node) {
    if (!node.real) return node.block < 0 ? MarkKind::InGap : MarkKind::Artificial;
    switch (node.state) {
        case NodeState::Bonded: return MarkKind::Bonded;
        case NodeState::Slipping: return MarkKind::Slipping;
        case NodeState::Gone: return MarkKind::Gone;
        case NodeState::Free: break;
    }
    return MarkKind::InGap;
}

Mark atElement(MarkKind kind, const BoltFrame& frame, const std::vector<Point>& nodes, std::size_t element) {
    return {kind, 0.5 * (frame.nodes[element].s + frame.nodes[element + 1].s),
            0.5 * (nodes[element] + nodes[element + 1]), directionAt(nodes, element)};
}

void addSteel(int index, const BoltFrame& frame, const std::vector<Point>& nodes, std::span<const Event> events,
              std::vector<Mark>& marks) {
    for (std::size_t e = 0; e + 1 < frame.nodes.size(); ++e)
        if (frame.nodes[e].ruptured) marks.push_back(atElement(MarkKind::Ruptured, frame, nodes, e));
    for (const Event& event : events) {
        if (event.bolt != index) continue;
        const auto element = static_cast<std::size_t>(event.element), node = static_cast<std::size_t>(event.node);
        if (event.kind == EventKind::Yield && event.element >= 0 && element + 1 < nodes.size())
            marks.push_back(atElement(MarkKind::Yielded, frame, nodes, element));
        if (event.kind == EventKind::Hinge && event.node >= 0 && node < nodes.size())
            marks.push_back({MarkKind::Yielded, frame.nodes[node].s, nodes[node], directionAt(nodes, node)});
    }
}

int rankOf(MarkKind kind) {
    switch (kind) {
        case MarkKind::Artificial:
        case MarkKind::InGap: return 0;
        case MarkKind::Bonded: return 1;
        case MarkKind::Slipping:
        case MarkKind::Gone: return 2;
        case MarkKind::Yielded: return 3;
        default: return 4;
    }
}

bool crowds(const Mark& kept, const Mark& mark, double least) {
    const double apart = std::abs(kept.s - mark.s);
    if (rankOf(mark.kind) >= 2) return kept.kind == mark.kind && apart < 0.6 * least;
    return apart < least;
}

}  // namespace

std::vector<Mark> marksOf(const Bolt& bolt, int index, const BoltFrame& frame, const std::vector<Point>& nodes,
                          std::span<const Event> events) {
    std::vector<Mark> marks;
    if (nodes.empty()) return marks;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        marks.push_back({kindOf(frame.nodes[i]), frame.nodes[i].s, nodes[i], directionAt(nodes, i)});
    addSteel(index, frame, nodes, events, marks);
    if (bolt.plate == PlateKind::Spring) {
        const bool lost = std::any_of(events.begin(), events.end(), [&](const Event& e) {
            return e.bolt == index && e.kind == EventKind::PlateLoss;
        });
        const std::size_t head = nodes.size() - 1;
        if (frame.plateHolds || lost)
            marks.push_back({frame.plateHolds ? MarkKind::Plate : MarkKind::PlateLost, frame.nodes[head].s, nodes[head],
                             directionAt(nodes, head)});
    }
    return marks;
}

std::vector<Mark> thinned(std::vector<Mark> marks, double least) {
    std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
        return rankOf(a.kind) != rankOf(b.kind) ? rankOf(a.kind) > rankOf(b.kind) : a.s < b.s;
    });
    std::vector<Mark> kept;
    for (const Mark& mark : marks)
        if (std::none_of(kept.begin(), kept.end(), [&](const Mark& other) { return crowds(other, mark, least); }))
            kept.push_back(mark);
    std::reverse(kept.begin(), kept.end());  // the most important mark is drawn last
    return kept;
}

}  // namespace keyblock
