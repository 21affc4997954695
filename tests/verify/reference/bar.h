// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An independent calculation of a bolt across one joint: linear or
// elastic-plastic bars along a line, springs to a fixed and to a moving block,
// one release at a time. It shares no line with the program that it checks.
//
// Nothing is stepped. Between two events the model is linear, so its rates are
// solved once and the model is carried to exactly where the next corner of a
// curve or the next limit lies. A spring that reaches its limit is dropped to
// its residual force at the same opening (or load); if that leaves others over
// their limit the largest ratio of force to strength goes next, and of ratios
// within 1e-6 the lowest node.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace keyblock::reference {

/// Force over deformation from the origin, unloading along its first slope.
using Curve = std::vector<std::pair<double, double>>;

enum class Side { Fixed, Moving };

/// Ties a node to the rock beside it.
struct BarSpring {
    int node = 0;
    Side side = Side::Fixed;
    Curve curve;  // one point: linear [m, N]
    std::optional<double> peak;  // [N] lets go there
    double residual = 0.0;  // [N] constant after that
    bool plate = false;  // goes after nodes in a tie
    bool restick = false;  // the residual is friction: it unloads elastically when the slip turns
};

struct BarProblem {
    std::vector<double> s;  // [m] nodes
    double area = 0.0;  // [m²]
    Curve steel;  // strain, stress [Pa]; one point: linear
    std::optional<double> breaksAt;  // [N] force that breaks the steel; null: the curve's last strain
    bool unbreakable = true;  // no rupture at all
    std::vector<BarSpring> springs;
    std::optional<double> blockStiffness;  // E × volume of the moving block [N m]; null: rigid
    double blockCentre = 0.0;  // [m] where its displacement is prescribed or its load acts
    double openingAt = 0.0;  // [m] point of the moving block where the opening is read
};

enum class BarEventKind { Release, Corner, Rupture };

/// State just before (and for a release just after) an event.
struct BarEvent {
    BarEventKind kind = BarEventKind::Release;
    int node = -1;  // of the spring; −1: none
    int element = -1;
    bool plate = false;
    double load = 0.0;  // [N] through the joint
    double loadAfter = 0.0;
    double opening = 0.0;  // [m]
};

struct BarResult {
    std::vector<BarEvent> events;
    std::vector<std::pair<double, double>> path;  // (opening [m], load [N]), linear between
    std::vector<double> elementForce;  // [N] at the end
    std::vector<double> springForce;  // [N] at the end, positive: rock pulls towards the moving side

    std::vector<BarEvent> releases() const;  // of springs
    double largestLoad() const;
    double openingAtLargestLoad() const;
    /// Load at an opening, between the points of the path.
    double loadAt(double opening) const;
    /// First event of a kind, if any.
    std::optional<BarEvent> first(BarEventKind kind) const;
};

/// Pulls the moving block's centre from 0 to `displacement` [m].
BarResult pullTo(const BarProblem& problem, double displacement);

/// Loads the moving block from 0 to `force` [N]; ends early at the first release.
BarResult loadTo(const BarProblem& problem, double force);

}  // namespace keyblock::reference
