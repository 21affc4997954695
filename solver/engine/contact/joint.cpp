// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/joint.h"

#include "solver/engine/contact/candidates.h"
#include "solver/engine/model/edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace keyblock {
namespace {

int weakerJoint(const Model& model, int x, int y) {
    const auto strength = [&](int i) {
        return std::tuple(i == intactRow(model), model.joints[i].tanPhi, model.joints[i].cohesion);
    };
    return strength(y) < strength(x) ? y : x;
}

/// The edges at the contact's corner that lie along the contact's edge and face it; both edges at the corner if neither
/// does.
std::array<int, 2> edgesAtCorner(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c,
                                 bool& meets) {
    const std::vector<Point>& corners = blocks[c.blockA].corners;
    const int n = static_cast<int>(corners.size()), before = (c.corner + n - 1) % n;
    const Point along = edgeOf(blocks[c.blockB].corners, c.edge).along;
    const auto lies = [&](int edge) {
        const Point own = edgeOf(corners, edge).along;
        return own.dot(along) < 0.0 && std::abs(cross(own, along)) <= angleSlack;
    };
    const bool first = lies(before), second = lies(c.corner);
    meets = (first || second) && model.blocks[c.blockA].plateOf < 0 && model.blocks[c.blockB].plateOf < 0;
    return {first || !second ? before : c.corner, second || !first ? c.corner : before};
}

}  // namespace

int governingJoint(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c, bool first) {
    const BlockModel &a = model.blocks[c.blockA], &b = model.blocks[c.blockB];
    if (a.faceJoints.empty() && b.faceJoints.empty()) return weakerJoint(model, a.jointMaterial, b.jointMaterial);
    bool meets = false;
    const std::array<int, 2> edges = edgesAtCorner(model, blocks, c, meets);
    const auto jointOn = [&](const BlockModel& block, int edge) {
        const int joint = jointOfFace(block, edge);
        return joint == intactRow(model) && !(first && meets) ? block.jointMaterial : joint;
    };
    const int own = weakerJoint(model, jointOn(a, edges[0]), jointOn(a, edges[1]));
    return weakerJoint(model, own, jointOn(b, c.edge));
}

int openingBetween(const Model& model, const Contact& c) {
    const std::vector<int> &a = model.blocks[c.blockA].faceOpenings, &b = model.blocks[c.blockB].faceOpenings;
    if (a.empty() || b.empty()) return -1;
    const std::size_t corner = c.corner;
    const int opening = b[c.edge];
    return a[corner] == opening || a[(corner + a.size() - 1) % a.size()] == opening ? opening : -1;
}

double openingOf(const std::vector<double>& openings, const Contact& c) {
    const double own = c.opening < 0 ? 0.0 : openings[c.opening];
    return openings[c.joint] + own;
}

double widestOpening(const State& state) {
    double widest = 0.0;
    if (state.openings.empty()) return widest;
    for (const Contact& c : state.contacts) widest = std::max(widest, c.dilation);
    return widest;
}

void meetDilated(const State& state, std::vector<Contact>& contacts) {
    if (state.openings.empty()) return;
    for (Contact& c : contacts) {
        const double opening = openingOf(state.openings, c) - c.dilation;
        if (opening == 0.0) continue;
        c.dilation += opening;
        if (c.gap > c.gapOffset) c.gapOffset = std::min(c.gap, c.gapOffset + opening);
    }
}

}  // namespace keyblock
