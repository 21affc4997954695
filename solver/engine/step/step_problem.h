// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One step as a minimisation problem. Blocks and bolt nodes are bodies with six and
// three unknowns. Everything that connects them is a link with one strain, linear in
// the step's displacements, and one scalar law. For given friction limits the energy
// is convex and piecewise quadratic (theory, "The step").
#pragma once

#include "solver/engine/laws/step_law.h"
#include "solver/engine/vector6.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace keyblock {

enum class LinkKind { Normal, Friction, Glue, Support, AnchorNormal, AnchorSlip, Axial, Bend, Shear, Chord, PlateNormal, PlateShear,
                      Drag };

/// Link between two bodies, or acting on a single body. Its strain at the end of the step is
/// `strain` + `shift` + `ga`·D[a] + `gb`·D[b], where D[a] and D[b] are the displacements of the bodies over the step.
/// The gradients are the last members so that loops over the laws read contiguous data.
struct Link {
    LinkKind kind = LinkKind::Normal;
    int a = -1, b = -1;  // bodies; b is −1 if the link acts on one body only
    double strain = 0.0;  // at the start of the step
    double shift = 0.0;  // strain added by dilation over the step, or by the part of a rotation that ga·D misses [m]
    Law law;
    int owner = -1;  // contact, or bolt
    int part = -1;  // node or element of the bolt
    std::uint64_t features = 0;  // for a contact: its corner and edge, which identify it in the next step
    Vector6 ga = Vector6::Zero(), gb = Vector6::Zero();  // a node uses the first three
};

/// Dependence of the limit of a link with a capped law on the force F of another link. Neither the limit nor F is
/// multiplied by `Law::share`.
struct LimitPair {
    enum class Rule {
        Push,  // base + factor·⟨−F⟩: joint, with the tangent of its friction angle as factor
        Clamp  // base + factor·|F|: anchored point, with F from its normal spring
    };
    int limited = -1, from = -1;  // rows of the two links; `from` comes earlier
    double factor = 0.0;
    double base = 0.0;
    Rule rule = Rule::Push;
};

struct StepProblem {
    int blocks = 0, nodes = 0;
    std::vector<Link> links;
    std::vector<LimitPair> limitPairs;
    StepRule rule;  // force over the step that the scheme uses for each law
    double contactShare = 1.0;  // generalized-α: weight of contact forces relative to the other forces
    std::vector<double> slipForce;  // per link: mean force while sliding; empty: the force at the end is used
    std::vector<Matrix6> blockStiffness;  // inertia and elasticity
    std::vector<Eigen::Vector3d> nodeStiffness;  // inertia, diagonal
    Eigen::VectorXd load;  // external force and inertia of the motion so far, minus the force of the current stress
    std::vector<char> known;  // per unknown: true if prescribed by `value`
    Eigen::VectorXd value;
    Eigen::VectorXd weight;  // 1/length for moments and strain terms, so that all residuals are forces
    double floorForce = 0.0;  // smallest reference force [N]
    std::vector<double> openings;  // joint openings at the end of the step, as LoadPoint::openings [m]
    double externalForce = 0.0;  // sum of the magnitudes of the external forces [N]
    bool moves = false;  // true for a dynamic step
    std::vector<double> ownForce;  // per body: magnitude of its loads plus a small minimum [N]
    // per block, in a dynamic step: unbalanced force at zero displacement that needs no solution [N]; empty: round-off
    std::vector<double> startForce;
    // per body: its position [m], for the order of elimination; empty in the step of a part (`localStep`)
    std::vector<Eigen::Vector2d> places;
    std::vector<double> mayLeave;  // per body: allowed unbalanced force [N]; empty: relative tolerance only

    int unknowns() const { return 6 * blocks + 3 * nodes; }
    int first(int body) const { return body < blocks ? 6 * body : 6 * blocks + 3 * (body - blocks); }
    int width(int body) const { return body < blocks ? 6 : 3; }
};

/// True if no unknown of a body is free.
inline bool isDriven(const StepProblem& problem, int body) {
    const auto first = problem.known.begin() + problem.first(body);
    return std::all_of(first, first + problem.width(body), [](char known) { return known != 0; });
}

inline bool ofContact(LinkKind kind) { return kind == LinkKind::Normal || kind == LinkKind::Friction; }

/// Rule for calculating the force of a link over the step. With generalized-α, contacts use the energy-conserving rule
/// (theory, "Time").
inline StepRule ruleOf(const StepProblem& problem, const Link& link) {
    if (link.law.rigid) return {};  // the force at the end of the step, whatever it was at the start
    if (problem.rule.rule == ForceRule::Blend && ofContact(link.kind)) return {ForceRule::Average, 0.5};
    return problem.rule;
}

/// Force and tangent with which a link enters the step's equilibrium equations if its strain at the end of the step is
/// `e`. Neither is multiplied by `Law::share`.
inline LawResponse respond(const StepProblem& problem, const Link& link, double e) {
    LawResponse r = respondOverStep(link.law, link.strain, e, ruleOf(problem, link));
    if (problem.contactShare == 1.0 || !ofContact(link.kind)) return r;
    return {problem.contactShare * r.force, problem.contactShare * r.tangent};
}

}  // namespace keyblock
