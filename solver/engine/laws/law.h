// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scalar laws of all links: they give force and tangent for a strain. Each law is the
// derivative of a convex potential, so that a step can be solved as a minimisation
// problem (theory, "The step").
#pragma once

#include "solver/engine/laws/backbone.h"

#include <algorithm>

namespace keyblock {

enum class LawKind {
    Linear,  // k·(e − offset)
    Gap,  // k·(e − offset) in compression (≤ 0), otherwise 0
    Capped,  // k·(e − offset) limited to ± limit: Coulomb friction with a given limit
    Constant,  // the force `limit` at any strain
    Curve,  // backbone curve with a plastic state
    Viscous  // k·(e − offset) at the end of the step in all time schemes; stores no energy
};

struct Law {
    LawKind kind = LawKind::Linear;
    double stiffness = 0.0;
    double offset = 0.0;
    double limit = 0.0;
    const Backbone* curve = nullptr;
    BackboneState state;
    double share = 1.0;  // factor of force, tangent and energy in the model
    bool rigid = false;  // the stiffness serves only to find the force; no energy is stored
    double leastTangent = 0.0;  // tangent over `stiffness` where the law is flat, so that Newton's matrix stays regular
};

struct LawResponse {
    double force = 0.0;  // not multiplied by `share`
    double tangent = 0.0;
};

/// Force and tangent at strain `e`, not multiplied by `share`.
inline LawResponse respond(const Law& law, double e) {
    const double trial = law.stiffness * (e - law.offset);
    switch (law.kind) {
        case LawKind::Linear:
        case LawKind::Viscous: return {trial, law.stiffness};
        case LawKind::Gap: return trial <= 0.0 ? LawResponse{trial, law.stiffness} : LawResponse{};
        case LawKind::Capped:
            if (trial > law.limit) return {law.limit, law.leastTangent * law.stiffness};
            if (trial < -law.limit) return {-law.limit, law.leastTangent * law.stiffness};
            return {trial, law.stiffness};
        case LawKind::Constant: return {law.limit, 0.0};
        case LawKind::Curve: {
            const BackboneResponse r = respond(*law.curve, law.state, e);
            return {r.force, std::max(r.tangent, 0.0)};
        }
    }
    return {};
}

/// Elastic energy f²/(2k) stored at force f with stiffness k, not multiplied by `share`; 0 for laws that store no
/// energy.
inline double storedEnergy(const Law& law, double force) {
    if (law.kind == LawKind::Constant || law.kind == LawKind::Viscous || law.rigid) return 0.0;
    const double k = law.kind == LawKind::Curve ? law.curve->modulus : law.stiffness;
    return k > 0.0 ? 0.5 * force * force / k : 0.0;
}

}  // namespace keyblock
