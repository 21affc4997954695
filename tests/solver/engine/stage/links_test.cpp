// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every link's gradient is the derivative of its strain, and the forces that it
// puts on its two bodies balance, wherever the bodies are.
#include "solver/engine/bolt/bolt.h"
#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/links.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/support.h"
#include "solver/verify/scenes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace keyblock {
namespace {

/// Two blocks, a point support, a bolt across their joint with anchors of all kinds and a plate.
Scene everything() {
    Scene scene = twoBlocks(10e9, 1.0, 2.0);
    Support point;
    point.point = Point(2.0, 0.0);
    point.fix = Fix::XY;
    scene.supports.push_back(point);
    BoltType type = steelType(barArea(), {{0.0, 0.0}, {0.002, 400e6}, {0.1, 500e6}});
    type.anchors = {anchorRange(Per::Length, AnchorLaw::Elastic, 1e9, std::nullopt, 0.0)};
    addBolt(scene, type, 0.2, 2.0, 6, PlateKind::Spring);
    scene.bolts[0].head = {2.0, 0.9};  // across the joint at an angle
    return scene;
}

struct Setting {
    Model model = makeModel(everything());
    State state = makeState(model);

    /// The whole scene turned by 0.8 rad, its parts a little apart from where they would then be.
    Setting() {
        state.contacts = findContacts(model, state.blocks, {}, 0.01, true);
        placeBolts(model, state);
        const double turn = 0.8;
        const Eigen::Rotation2D<double> rotation(turn);
        for (std::size_t i = 0; i < model.blocks.size(); ++i) {
            BlockMotion& block = state.blocks[i];
            const Point shift = rotation * block.centroid - block.centroid;
            const double off = 1e-6 * (static_cast<double>(i) + 1.0);
            moveBlock(model.blocks[i], block,
                      (Vector6() << shift.x() + off, shift.y() - 2 * off, turn + 3 * off, off, -off, off).finished());
            turnUnknowns(block, {0.5, 0.3 + off});
        }
        double off = 1e-6;
        for (BoltNode& node : state.bolts[0].nodes) {
            node.x = rotation * node.x + Point(off, -off);
            node.angle += turn + off;
            off *= -1.3;
        }
    }

    std::vector<Link> links(const State& at) const {
        StepProblem problem;
        problem.blocks = static_cast<int>(model.blocks.size());
        problem.nodes = model.nodes;
        addContactLinks(model, at, false, problem);
        addSupportLinks(model, at, {}, problem);
        addBoltLinks(model, at, 0, problem);
        // the chord's strain is of the step alone, and it is there in tension only
        std::erase_if(problem.links, [](const Link& link) { return link.kind == LinkKind::Chord; });
        return problem.links;
    }

    bool isBlock(int body) const { return body < static_cast<int>(model.blocks.size()); }
    const BoltNode& node(int body) const { return state.bolts[0].nodes[body - 2]; }

    State moved(int body, int unknown, double by) const {
        State at = state;
        if (isBlock(body)) {
            Vector6 d = Vector6::Zero();
            d[unknown] = by;
            moveBlock(model.blocks[body], at.blocks[body], d);
            return at;
        }
        BoltNode& n = at.bolts[0].nodes[body - 2];
        if (unknown < 2) n.x[unknown] += by;
        else n.angle += by;
        return at;
    }

    /// Force and moment about the origin that a gradient puts on a body.
    Eigen::Vector3d wrench(int body, const Vector6& g) const {
        if (body < 0) return Eigen::Vector3d::Zero();
        Point force = g.head<2>(), place;
        if (isBlock(body)) {
            const BlockMotion& block = state.blocks[body];
            force = g[0] * block.axis + g[1] * turnLeft(block.axis);
            place = block.centroid;
        } else {
            place = node(body).x;
        }
        return {force.x(), force.y(), g[2] + cross(place, force)};
    }
};

TEST(Links, AllKindsAreThere) {
    const Setting setting;
    std::set<LinkKind> kinds;
    for (const Link& link : setting.links(setting.state)) kinds.insert(link.kind);
    for (const LinkKind kind : {LinkKind::Normal, LinkKind::Friction, LinkKind::Support, LinkKind::AnchorNormal,
                                LinkKind::AnchorSlip, LinkKind::Axial, LinkKind::Bend, LinkKind::Shear,
                                LinkKind::PlateNormal, LinkKind::PlateShear})
        EXPECT_TRUE(kinds.contains(kind)) << static_cast<int>(kind);
}

TEST(Links, GradientIsTheDerivativeOfTheStrain) {
    const Setting setting;
    const std::vector<Link> links = setting.links(setting.state);
    constexpr double h = 1e-6;
    for (int body = 0; body < 2 + setting.model.nodes; ++body)
        for (int k = 0; k < (setting.isBlock(body) ? 6 : 3); ++k) {
            const std::vector<Link> ahead = setting.links(setting.moved(body, k, h));
            const std::vector<Link> behind = setting.links(setting.moved(body, k, -h));
            ASSERT_EQ(ahead.size(), links.size());
            for (std::size_t i = 0; i < links.size(); ++i) {
                const double slope = (ahead[i].strain - behind[i].strain) / (2.0 * h);
                double expected = 0.0;
                if (links[i].a == body) expected += links[i].ga[k];
                if (links[i].b == body) expected += links[i].gb[k];
                // the strains are linear but for the parts' distance from each other, some 1e-5
                EXPECT_NEAR(slope, expected, 5e-5) << "link " << i << " of kind " << static_cast<int>(links[i].kind)
                                                   << ", body " << body << ", unknown " << k;
            }
        }
}

TEST(Links, ForcesOnTheTwoBodiesBalance) {
    const Setting setting;
    for (const Link& link : setting.links(setting.state)) {
        if (link.kind == LinkKind::Support) continue;
        const Eigen::Vector3d sum = setting.wrench(link.a, link.ga) + setting.wrench(link.b, link.gb);
        EXPECT_LT(sum.norm(), 1e-12 * (1.0 + link.ga.norm())) << static_cast<int>(link.kind);
    }
}

}  // namespace
}  // namespace keyblock
