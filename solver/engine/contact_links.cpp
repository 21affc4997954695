// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corner before an edge as two links: the gap, which only pushes, and the
// slip, which friction holds up to its limit.
#include "solver/engine/contacts.h"
#include "solver/engine/step_build.h"

#include <limits>

namespace keyblock {

void addContactLinks(const Model& model, const State& state, bool frictionLocked, StepProblem& problem) {
    for (std::size_t i = 0; i < state.contacts.size(); ++i) {
        const Contact& c = state.contacts[i];
        const BlockMotion& a = state.blocks[c.blockA];
        const BlockMotion& b = state.blocks[c.blockB];
        const Point& corner = a.corners[c.corner];
        const Edge edge = edgeOf(b.corners, c.edge);
        const Eigen::Matrix<double, 2, 6> ta = displacementMatrix(a, corner), tb = displacementMatrix(b, corner);
        const auto add = [&](LinkKind kind, const Point& direction, double strain) -> Link& {
            Link& link = problem.links.emplace_back();
            link.kind = kind;
            link.owner = static_cast<int>(i);
            link.a = c.blockA;
            link.b = c.blockB;
            link.ga = ta.transpose() * direction;
            link.gb = -tb.transpose() * direction;
            link.strain = strain;
            return link;
        };
        const double kn = contactStiffness(model, c.blockA, c.blockB);
        const Point from = corner - edge.start;
        Link& normal = add(LinkKind::Normal, edge.outward, edge.outward.dot(from));
        normal.law = {c.bonded ? LawKind::Linear : LawKind::Gap, kn, c.gapOffset, 0.0, nullptr, {}, 1.0};
        const double slip = edge.along.dot(from) - c.lockPlace * edge.length;
        const bool locked = frictionLocked || c.bonded;
        const double limit = frictionLocked ? std::numeric_limits<double>::infinity() : c.limit;
        Link& friction = add(LinkKind::Friction, edge.along, slip);
        friction.law = {locked ? LawKind::Linear : LawKind::Capped, model.analysis.shearRatio * kn, c.slipOffset, limit,
                        nullptr, {}, 1.0};
        const int at = static_cast<int>(problem.links.size()) - 1;
        if (!locked) problem.frictions.push_back({at, at - 1, model.joints[c.joint].tanPhi});
    }
}

}  // namespace keyblock
