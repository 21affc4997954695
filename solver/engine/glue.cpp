// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/glue.h"

#include "solver/engine/step/step_forces.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace keyblock {
namespace {

constexpr double leastWay = 0.5;  // of the smaller cell's size: where slivers were merged, centroids may be close
constexpr double turnShare = 1e-4;  // of a block's largest glue force: allowed error due to rotation of its cells
constexpr double placeDigits = 1e-14;  // of a coordinate: smaller strains are round-off

Point turned(const Point& p, double angle) {
    return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

/// Position of the glued edge in both cells; its direction turns with their mean rotation.
struct GlueLine {
    Point along{1.0, 0.0}, across{0.0, 1.0};  // `across` points from a to b
    Point jump{0.0, 0.0};  // from a's midpoint of the edge to b's [m]
    Point middle{0.0, 0.0};  // midpoint of the two [m]
    double slope = 0.0;  // change of the gap along the edge [rad]
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

/// Weighted mean of two lines. Halfway, its directions are means as well and slightly shorter than 1, so that the
/// strain grows over the step in accordance with the gradients there (theory, "Sub-blocks").
GlueLine between(const GlueLine& from, const GlueLine& to, double share) {
    const auto mean = [&](const auto& a, const auto& b) -> std::decay_t<decltype(a)> { return a + share * (b - a); };
    return {mean(from.along, to.along), mean(from.across, to.across), mean(from.jump, to.jump),
            mean(from.middle, to.middle), mean(from.slope, to.slope)};
}

std::array<double, 3> strainsOf(const GlueLine& line) {
    return {line.across.dot(line.jump), line.along.dot(line.jump), line.slope};
}

/// Mean velocity of all cells of a block together [m/s].
Point meanVelocity(const Model& model, const State& state, int first) {
    Point momentum(0.0, 0.0);
    double mass = 0.0;
    for (int i = first; i < endOfWhole(model, first); ++i) {
        momentum += model.blocks[i].mass * centroidVelocity(state.blocks[i]);
        mass += model.blocks[i].mass;
    }
    return momentum / mass;
}

Vector6 wayOf(const Eigen::VectorXd& path, int block) { return path.segment<6>(6 * static_cast<Eigen::Index>(block)); }

/// Positions of the cells after a fraction of the path; the entries of other blocks are not used.
std::vector<BlockMotion> cellsAlong(const Model& model, const std::vector<BlockMotion>& from,
                                    const Eigen::VectorXd& path, double share) {
    std::vector<BlockMotion> cells(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (!model.blocks[i].cell) continue;
        cells[i] = from[i];
        if (!model.blocks[i].fixed) moveBlock(model.blocks[i], cells[i], share * wayOf(path, static_cast<int>(i)));
    }
    return cells;
}

class GlueLinks {
public:
    /// \param line position of the edge with the cells at `a` and `b`.
    GlueLinks(const GlueModel& glue, const BlockMotion& a, const BlockMotion& b, const GlueLine& line, int owner,
              StepProblem& problem)
        : glue_(glue), a_(a), b_(b), line_(line), owner_(owner), problem_(problem) {}

    /// \param strains at the start of the step.
    void add(const std::array<double, 3>& strains, const std::array<double, 3>& offsets) {
        const auto ta = displacementMatrix(a_, line_.middle), tb = displacementMatrix(b_, line_.middle);
        link(0, strains, glue_.normal, offsets, -ta.transpose() * line_.across, tb.transpose() * line_.across);
        link(1, strains, glue_.shear, offsets, -ta.transpose() * line_.along, tb.transpose() * line_.along);
        const Point half = 0.5 * line_.along;
        const auto slopeOf = [&](const BlockMotion& motion) -> Vector6 {
            return (displacementMatrix(motion, line_.middle + half) - displacementMatrix(motion, line_.middle - half))
                       .transpose() * line_.across;
        };
        link(2, strains, glue_.turn, offsets, -slopeOf(a_), slopeOf(b_));
    }

private:
    void link(int part, const std::array<double, 3>& strains, double stiffness, const std::array<double, 3>& offsets,
              const Vector6& ga, const Vector6& gb) {
        Link& l = problem_.links.emplace_back();
        l.kind = LinkKind::Glue;
        l.owner = owner_;
        l.part = part;
        l.a = glue_.a;
        l.b = glue_.b;
        l.ga = ga;
        l.gb = gb;
        l.strain = strains[part];
        l.law.stiffness = stiffness;
        l.law.offset = offsets[part];
    }

    const GlueModel& glue_;
    const BlockMotion& a_;
    const BlockMotion& b_;
    GlueLine line_;
    int owner_;
    StepProblem& problem_;
};

bool carries(const Model& model, const State& state, const GlueModel& glue) {
    if (model.blocks[glue.a].fixed && model.blocks[glue.b].fixed) return false;
    return !state.blocks[glue.a].absent;  // cells of a block are present or absent together
}

void addGlueLinks(const StepInput& input, StepProblem& problem) {
    const StepOptions& options = input.options;
    if (!problem.moves || input.model.glue.empty()) return addGlueLinks(input.model, input.state, problem);
    addGlueLinksOver(input.model, input.state,
                     options.cellPath ? *options.cellPath : predictedCellPath(input.model, input.state, options.dt),
                     factorsOf(options).armTime, problem);
}

void addGlueEnergy(const Model& model, const State& state, StoredEnergy& energy) {
    StepProblem links = stepForLinks(model);
    addGlueLinks(model, state, links);
    energy.strain = addLinkEnergy(links, energy.strain);
}

}  // namespace

GlueModel glueModel(const Scene& scene, const Model& model, const SharedEdge& edge) {
    const BlockModel& a = model.blocks[edge.a];
    const BlockModel& b = model.blocks[edge.b];
    const Material& material = materialOf(scene, scene.blocks[a.rock]);
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

void addGlueLinks(const Model& model, const State& state, StepProblem& problem) {
    for (std::size_t i = 0; i < model.glue.size(); ++i) {
        const GlueModel& glue = model.glue[i];
        if (!carries(model, state, glue)) continue;
        const BlockMotion &a = state.blocks[glue.a], &b = state.blocks[glue.b];
        const GlueLine line = glueLine(glue, a, b);
        GlueLinks(glue, a, b, line, static_cast<int>(i), problem).add(strainsOf(line), state.glue[i].offset);
    }
}

void addGlueLinksOver(const Model& model, const State& state, const Eigen::VectorXd& path, double share,
                      StepProblem& problem) {
    const std::vector<BlockMotion> middle = cellsAlong(model, state.blocks, path, share);
    const std::vector<BlockMotion> end = cellsAlong(model, state.blocks, path, 1.0);
    for (std::size_t i = 0; i < model.glue.size(); ++i) {
        const GlueModel& glue = model.glue[i];
        if (!carries(model, state, glue)) continue;
        const GlueLine from = glueLine(glue, state.blocks[glue.a], state.blocks[glue.b]);
        const GlueLine to = glueLine(glue, end[glue.a], end[glue.b]);
        const std::size_t first = problem.links.size();
        GlueLinks(glue, middle[glue.a], middle[glue.b], between(from, to, share), static_cast<int>(i), problem)
            .add(strainsOf(from), state.glue[i].offset);
        const std::array<double, 3> after = strainsOf(to);
        for (std::size_t part = 0; part < 3; ++part) {
            Link& link = problem.links[first + part];
            link.shift = after[part] - link.strain - link.ga.dot(wayOf(path, link.a)) - link.gb.dot(wayOf(path, link.b));
        }
    }
}

Eigen::VectorXd predictedCellPath(const Model& model, const State& state, double time) {
    Eigen::VectorXd path = Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(model.blocks.size()));
    for (int first = 0; first < static_cast<int>(model.blocks.size()); first = endOfWhole(model, first)) {
        if (!model.blocks[first].cell) continue;
        const Point mean = meanVelocity(model, state, first);
        for (int i = first; i < endOfWhole(model, first); ++i) {
            const BlockMotion& cell = state.blocks[i];
            const Point own = centroidVelocity(cell) - mean;
            const Point chord = time * (mean + 0.5 * (own + turned(own, time * cell.velocity[2])));
            Vector6 way = time * cell.velocity;
            way.head<2>() << chord.dot(cell.axis), chord.dot(turnLeft(cell.axis));
            path.segment<6>(6 * static_cast<Eigen::Index>(i)) = way;
        }
    }
    return path;
}

bool glueHolds(const Model& model, const std::vector<BlockMotion>& from, const StepProblem& problem,
               const Eigen::VectorXd& d) {
    if (model.glue.empty()) return true;
    const std::vector<BlockMotion> end = cellsAlong(model, from, d, 1.0);
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    std::vector<double> most(model.firstOf.size(), 0.0), off = most;  // per block of the scene [N]
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.kind != LinkKind::Glue) continue;
        const GlueModel& glue = model.glue[link.owner];
        const GlueLine to = glueLine(glue, end[glue.a], end[glue.b]);
        const double arm = link.part == 2 ? 0.5 * glue.length : 1.0;
        const double error = std::abs(strainsOf(to)[link.part] - strains[i]);
        const double noise = placeDigits * (model.size + to.middle.norm()) / arm;
        const std::size_t rock = model.blocks[glue.a].rock;
        const double force = std::max(std::abs(respond(link.law, strains[i]).force),
                                      std::abs(respond(link.law, link.strain).force));
        most[rock] = std::max(most[rock], force / arm);
        if (error > noise) off[rock] = std::max(off[rock], link.law.stiffness * error / arm);
    }
    for (std::size_t rock = 0; rock < most.size(); ++rock)
        if (off[rock] > turnShare * most[rock]) return false;
    return true;
}

const Carrier glueCarrier{.name = "glue", .addLinks = addGlueLinks, .addStoredEnergy = addGlueEnergy};

}  // namespace keyblock
