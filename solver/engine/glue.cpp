// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/glue.h"

#include "solver/scene/lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {
namespace {

constexpr double leastWay = 0.5;  // of the smaller cell: cells that joined slivers may have close centroids

Point turned(const Point& p, double angle) {
    return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

/// Where the glued edge is in either cell; its direction turns with the mean of the two.
struct GlueLine {
    Point along{1.0, 0.0}, across{0.0, 1.0};  // `across` points from a to b
    Point jump{0.0, 0.0};  // b's middle from a's [m]
    Point middle{0.0, 0.0};  // between the two [m]
    double slope = 0.0;  // of the gap along the edge [rad]
};

GlueLine glueLine(const GlueModel& glue, const BlockMotion& a, const BlockMotion& b) {
    GlueLine line;
    line.along = turned(glue.along, 0.5 * (a.angle + b.angle));
    line.across = -turnLeft(line.along);
    const Point onA = materialPoint(a, glue.placeA), onB = materialPoint(b, glue.placeB);
    line.jump = onB - onA;
    line.middle = 0.5 * (onA + onB);
    const Point sideA = materialPoint(a, glue.placeA + glue.along) - onA;
    const Point sideB = materialPoint(b, glue.placeB + glue.along) - onB;
    line.slope = line.across.dot(sideB - sideA);
    return line;
}

BlockMotion ahead(const BlockModel& block, const BlockMotion& motion, double time) {
    BlockMotion moved = motion;
    if (time > 0.0 && !block.fixed) moveBlock(block, moved, time * motion.velocity);
    return moved;
}

class GlueLinks {
public:
    GlueLinks(const GlueModel& glue, const BlockMotion& a, const BlockMotion& b, int owner, StepProblem& problem)
        : glue_(glue), a_(a), b_(b), line_(glueLine(glue, a, b)), owner_(owner), problem_(problem) {}

    /// \param now where the edge is at the start of the step, from which strains count.
    void add(const GlueLine& now, const std::array<double, 3>& offsets) {
        const auto ta = displacementMatrix(a_, line_.middle), tb = displacementMatrix(b_, line_.middle);
        link(0, now.across.dot(now.jump), glue_.normal, offsets, -ta.transpose() * line_.across,
             tb.transpose() * line_.across);
        link(1, now.along.dot(now.jump), glue_.shear, offsets, -ta.transpose() * line_.along,
             tb.transpose() * line_.along);
        const Point half = 0.5 * line_.along;
        const auto slopeOf = [&](const BlockMotion& motion) -> Vector6 {
            return (displacementMatrix(motion, line_.middle + half) - displacementMatrix(motion, line_.middle - half))
                       .transpose() * line_.across;
        };
        link(2, now.slope, glue_.turn, offsets, -slopeOf(a_), slopeOf(b_));
    }

private:
    void link(int part, double strain, double stiffness, const std::array<double, 3>& offsets, const Vector6& ga,
              const Vector6& gb) {
        Link& l = problem_.links.emplace_back();
        l.kind = LinkKind::Glue;
        l.owner = owner_;
        l.part = part;
        l.a = glue_.a;
        l.b = glue_.b;
        l.ga = ga;
        l.gb = gb;
        l.strain = strain;
        l.law.stiffness = stiffness;
        l.law.offset = offsets[static_cast<std::size_t>(part)];
    }

    const GlueModel& glue_;
    const BlockMotion& a_;
    const BlockMotion& b_;
    GlueLine line_;
    int owner_;
    StepProblem& problem_;
};

/// Half of a step in motion: it keeps the angular momentum.
void addLinks(const StepInput& input, StepProblem& problem) {
    addGlueLinks(input.model, input.state, problem.moves ? 0.5 * input.options.dt : 0.0, problem);
}

void addStoredEnergy(const Model& model, const State& state, StoredEnergy& energy) {
    StepProblem links = stepForLinks(model);
    addGlueLinks(model, state, 0.0, links);
    energy.strain = addLinkEnergy(links, energy.strain);
}

}  // namespace

GlueModel glueModel(const Scene& scene, const Model& model, const SharedEdge& edge) {
    const BlockModel& a = model.blocks[edge.a];
    const BlockModel& b = model.blocks[edge.b];
    const Material& material = materialOf(scene, scene.blocks[static_cast<std::size_t>(a.rock)]);
    const double nu = material.poissonsRatio;
    const double modulus = material.youngsModulus / (scene.analysis.plane == Plane::Strain ? 1.0 - nu * nu : 1.0);
    const double shearModulus = 0.5 * material.youngsModulus / (1.0 + nu);
    GlueModel glue;
    glue.a = edge.a;
    glue.b = edge.b;
    const Point middle = 0.5 * (edge.from + edge.to);
    glue.placeA = middle - a.centroid;
    glue.placeB = middle - b.centroid;
    glue.length = (edge.to - edge.from).norm();
    glue.along = (edge.to - edge.from) / glue.length;
    const double across = -turnLeft(glue.along).dot(b.centroid - a.centroid);
    const double way = std::max(across, leastWay * std::min(a.size, b.size));
    const double face = glue.length * scene.analysis.thickness;
    glue.normal = glueMultiple * modulus / way * face;
    glue.shear = glueMultiple * shearModulus / way * face;
    glue.turn = modulus / way * face * glue.length * glue.length / 12.0;
    return glue;
}

void addGlueLinks(const Model& model, const State& state, double lead, StepProblem& problem) {
    std::vector<BlockMotion> places;  // taken ahead only where something is glued
    if (!model.glue.empty() && lead > 0.0)
        for (std::size_t i = 0; i < model.blocks.size(); ++i)
            places.push_back(model.blocks[i].cell ? ahead(model.blocks[i], state.blocks[i], lead) : BlockMotion{});
    const std::vector<BlockMotion>& at = places.empty() ? state.blocks : places;
    for (std::size_t i = 0; i < model.glue.size(); ++i) {
        const GlueModel& glue = model.glue[i];
        if (model.blocks[glue.a].fixed && model.blocks[glue.b].fixed) continue;
        if (state.blocks[glue.a].absent) continue;  // with all cells of its block
        GlueLinks(glue, at[glue.a], at[glue.b], static_cast<int>(i), problem)
            .add(glueLine(glue, state.blocks[glue.a], state.blocks[glue.b]), state.glue[i].offset);
    }
}

const Carrier glueCarrier{.name = "glue", .addLinks = addLinks, .addStoredEnergy = addStoredEnergy};

}  // namespace keyblock
