// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One step as a minimisation. Blocks and bolt nodes are bodies with six or
// three unknowns; everything between them is a link: one strain, linear in the
// step's displacements, and one scalar law. The energy is convex and piecewise
// quadratic for given friction limits (theory, "The step").
#pragma once

#include "solver/engine/laws/step_law.h"
#include "solver/engine/vector6.h"

#include <cstdint>
#include <vector>

namespace keyblock {

enum class LinkKind { Normal, Friction, Glue, Support, AnchorNormal, AnchorSlip, Axial, Bend, Shear, Chord, PlateNormal, PlateShear,
                      Drag };

/// strain(D) = strain + shift + ga·D[a] + gb·D[b]; gradients come last, so that what loops over laws read lies together
struct Link {
    LinkKind kind = LinkKind::Normal;
    int a = -1, b = -1;  // bodies; b may be −1
    double strain = 0.0;
    double shift = 0.0;  // added to the strain by what dilates over the step, or by what ga·D misses of a rotation [m]
    Law law;
    int owner = -1;  // contact, or bolt
    int part = -1;  // node or element of the bolt
    std::uint64_t features = 0;  // of a contact: its corner and edge, by which it is found again in the next step
    Vector6 ga = Vector6::Zero(), gb = Vector6::Zero();  // a node uses the first three
};

/// A capped link's limit that follows the force F of another link (before shares).
struct LimitPair {
    enum class Rule {
        Push,  // base + factor·⟨−F⟩: a joint, by the tangent of its friction angle
        Clamp  // base + factor·|F|: an anchored point, by its normal spring
    };
    int limited = -1, from = -1;  // links, `from` the earlier one
    double factor = 0.0;
    double base = 0.0;
    Rule rule = Rule::Push;
};

struct StepProblem {
    int blocks = 0, nodes = 0;
    std::vector<Link> links;
    std::vector<LimitPair> limitPairs;
    StepRule rule;  // which force of a law the scheme takes
    double contactShare = 1.0;  // generalized-α: weight of contacts against the rest in the step's balance
    std::vector<double> slipForce;  // per link: mean force while it slid; empty: the force at the end
    std::vector<Matrix6> blockStiffness;  // inertia and elasticity
    std::vector<Eigen::Vector3d> nodeStiffness;  // inertia, diagonal
    Eigen::VectorXd load;  // external force, inertia of the motion so far, less the stress there is
    std::vector<char> known;  // a row per unknown: prescribed by `value`
    Eigen::VectorXd value;
    Eigen::VectorXd weight;  // 1/length for moments and strains, so that all residuals are forces
    double floorForce = 0.0;  // [N] smallest reference force
    std::vector<double> openings;  // of joints where the step ends: LoadPoint::openings
    double externalForce = 0.0;  // summed |external| [N]
    bool moves = false;  // a step in motion
    std::vector<double> ownForce;  // per body: of its loads, and a floor [N]
    std::vector<double> mayLeave;  // per body, at most unbalanced [N]; empty: judged by the forces at play alone

    int unknowns() const { return 6 * blocks + 3 * nodes; }
    int first(int body) const { return body < blocks ? 6 * body : 6 * blocks + 3 * (body - blocks); }
    int width(int body) const { return body < blocks ? 6 : 3; }
};

inline bool ofContact(LinkKind kind) { return kind == LinkKind::Normal || kind == LinkKind::Friction; }

/// The rule for a link: contacts keep energy where the rest follows generalized-α (theory, "Time").
inline StepRule ruleOf(const StepProblem& problem, const Link& link) {
    if (link.law.rigid) return {};  // determined for the end of the step, whatever it was at its start
    if (problem.rule.rule == ForceRule::Blend && ofContact(link.kind)) return {ForceRule::Average, 0.5};
    return problem.rule;
}

/// Force and tangent that a link at strain `e` gives to the step's balance, before its law's share.
inline LawResponse respond(const StepProblem& problem, const Link& link, double e) {
    LawResponse r = respondOverStep(link.law, link.strain, e, ruleOf(problem, link));
    if (problem.contactShare == 1.0 || !ofContact(link.kind)) return r;
    return {problem.contactShare * r.force, problem.contactShare * r.tangent};
}

}  // namespace keyblock
