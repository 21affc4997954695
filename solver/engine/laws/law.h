// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scalar laws of everything that holds: strain in, force and tangent out.
// Each is the derivative of a convex potential, which is what lets a step be
// solved as a minimisation (theory, "The step").
#pragma once

#include "solver/engine/laws/backbone.h"

#include <algorithm>

namespace keyblock {

enum class LawKind {
    Linear,  // k·(e − offset)
    Gap,  // the same where it pushes or just touches, nothing where it would pull
    Capped,  // the same up to ± limit: Coulomb friction with a given limit
    Constant,  // the force `limit`, whatever the strain
    Curve,  // backbone with a plastic state
    Viscous  // k·(e − offset) at the step's end under every scheme, and nothing of it stored
};

struct Law {
    LawKind kind = LawKind::Linear;
    double stiffness = 0.0;
    double offset = 0.0;
    double limit = 0.0;
    const Backbone* curve = nullptr;
    BackboneState state;
    double share = 1.0;  // multiplies force, tangent and energy of the whole law in the model
    bool rigid = false;  // the stiffness only finds the force: nothing is stored
    double leastTangent = 0.0;  // over `stiffness`, given to Newton where the law is flat, so that no body is free
};

struct LawResponse {
    double force = 0.0;  // before `share`
    double tangent = 0.0;
};

/// Force and tangent at strain `e`; shares are left to the caller.
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

/// Elastic energy that a force stands for: f²/2k, before `share`.
inline double storedEnergy(const Law& law, double force) {
    if (law.kind == LawKind::Constant || law.kind == LawKind::Viscous || law.rigid) return 0.0;
    const double k = law.kind == LawKind::Curve ? law.curve->modulus : law.stiffness;
    return k > 0.0 ? 0.5 * force * force / k : 0.0;
}

}  // namespace keyblock
