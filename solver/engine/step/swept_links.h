// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The links visited by sweeps over contact forces, as compact rows in sweep order, so
// that all data of a visit are contiguous. The unknowns of a body are scaled by the
// Cholesky factor L of its own stiffness, x = Lᵀ·d. In these unknowns a unit force
// displaces the body by the gradient of the strain, so that each row needs one vector
// instead of two. Bolt nodes are not visited: each chain of them is condensed onto its
// blocks and acts in each sweep with the force that fits the displacements it causes.
#pragma once

#include "solver/engine/step/flat_law.h"
#include "solver/engine/step/link_rows.h"
#include "solver/engine/step/node_chains.h"

#include <array>
#include <vector>

namespace keyblock {

class SweptLinks {
public:
    /// Sums over one sweep: of the squared force changes (`changed`), without the parts that only bring a force into its
    /// present range (for friction, also a decrease of its limit), and of the squared forces (`forces`).
    struct Change {
        double changed = 0.0, forces = 0.0;
    };

    /// Collects the links between blocks; links of bolt nodes and links without stiffness are left out.
    SweptLinks(StepProblem& problem, const LinkRows& rows);

    /// True if each block's own stiffness matrix is positive definite, as the sweeps require.
    bool possible() const { return possible_; }

    std::size_t count() const { return rows_.size(); }

    /// Index of swept link n in `StepProblem::links`.
    std::size_t linkOf(std::size_t n) const { return sources_[n].link; }

    /// Sets the forces on the blocks that are constant during the sweeps, and condenses the bolt nodes at a trial.
    /// \param outer the generalised force of loads and prescribed displacements (padded).
    void hold(const Eigen::VectorXd& outer, const Trial& from);

    /// Limits each force to the range that its law allows.
    /// \param forces one force per swept link, not multiplied by `Law::share` [N].
    void clip(std::vector<double>& forces);

    /// Like `clip`, but then also moves the blocks to equilibrium under the limited forces.
    void clipAndPlace(std::vector<double>& forces);

    /// True if bolt nodes are condensed, so that the swept links do not determine all displacements.
    bool hasChains() const { return nodes_.count() > 0; }

    /// Displacements of the blocks under the current forces (padded). \pre no bolt nodes are condensed.
    Eigen::VectorXd displacement() const;

    /// Scaled displacements Lᵀ·d of the blocks under the current forces (padded). They depend linearly on the forces.
    /// The scaled forces of the chains of bolt nodes follow them.
    Eigen::VectorXd& placed() { return moved_; }

    /// Sets each force in turn to the value given by its law, taking into account the block displacements that the
    /// force itself causes.
    /// \param forces one force per swept link, not multiplied by `Law::share` [N].
    /// \param changes receives the force changes, one per swept link.
    /// \pre the blocks are in equilibrium under the forces passed in.
    Change sweep(std::vector<double>& forces, Eigen::VectorXd& changes);

    /// Estimate of how much the forces that the laws give at the current displacements differ from the swept forces:
    /// the square root of the sum of squares [N].
    /// \param changes the force changes of the last sweep.
    double mismatch(const Eigen::VectorXd& changes) const;

    /// Friction limit of swept link n if the swept links have the forces `forces` [N].
    double limit(std::size_t n, const std::vector<double>& forces) const;

    /// A strain at which the law of swept link n gives `force`. If the law is flat there, it is one of many.
    double strain(std::size_t n, double force) const;

    /// Tangent of the law of swept link n on its elastic branch, i.e. while the link is neither sliding nor open [N/m].
    double tangent(std::size_t n) const;

private:
    static constexpr int mostInGroup = 4;  // e.g. two contacts, each with a normal force and friction

    /// What a sweep reads of a swept link, in addition to its bounds. A link has the force trial = `base` + `own`·force +
    /// `gain`·gradient·x if it is within its bounds; x are the scaled displacements, including those due to its force.
    struct Row {
        std::array<double, 12> gradient{};  // scaled, six entries for each body
        double base = 0.0, own = 0.0;
        double gain = 0.0;  // force per strain that the link would have without its own force [N/m]
        double share = 1.0;
        // decrease of the trial forces of the next rows of its group per unit of change of its force
        std::array<double, mostInGroup - 1> onNext{};
        int firstA = 0, firstB = 0;  // first unknowns of the two bodies
    };
    /// Other data of a swept link. In a sweep they are needed only if its law is bent.
    struct Source {
        double start = 0.0;  // strain at zero scaled displacement
        double compliance = 0.0;  // strain per unit force
        double stiffness = 0.0, offset = 0.0;  // of its law
        int pair = -1;  // row of limitPairs; −1: none
        std::size_t link = 0;
    };
    /// Successive rows of the same two bodies.
    struct Group {
        std::size_t first = 0;
        int count = 0;
        bool bent = false;  // at least one of their laws must be evaluated itself
    };
    /// Bounds of a force while the others are as they are [N].
    struct Range {
        double low = 0.0, high = 0.0;
    };
    /// A chain of bolt nodes in scaled unknowns. Its force on its blocks is `force` − `give`·x, where x are their
    /// displacements without this force.
    struct Chain {
        Eigen::MatrixXd give;
        Eigen::VectorXd force;
        int first = 0;  // of its force in `moved_`
    };

    void scaleBlocks();
    void addRow(std::size_t link, int pair);
    void scaleGradient(std::size_t link, Row& row) const;
    void makeGroups();
    void move(const Row& row, double force);
    Range range(std::size_t n, const double* forces) const;
    Range flatRange(std::size_t n, double previous) const;
    Range bentRange(std::size_t n, const double* forces) const;
    double bentForce(std::size_t n, double free, double force);
    template <int Count>
    Change sweepGroup(std::size_t first, double* forces, double* changes);
    Change sweepBent(std::size_t n, double* forces, double* changes);
    void holdChains(const Trial& from);
    void sweepChains();

    StepProblem& problem_;
    const LinkRows& links_;
    bool possible_ = true;
    std::vector<Matrix6> scales_;  // per block: L⁻¹; columns of prescribed unknowns are zero
    std::vector<Row> rows_;  // each normal force before its friction
    std::vector<Source> sources_;  // per row
    std::vector<Group> groups_;  // of all rows, in their order
    std::vector<FlatBounds> bounds_;  // per row; apart from it, for the loops that only limit the forces
    std::vector<double> bentStrains_;  // per row
    Eigen::VectorXd driven_;  // prescribed displacements (padded)
    // scaled displacements (padded): under the force set by `hold` alone, and under all forces
    Eigen::VectorXd held_, moved_;
    NodeChains nodes_;
    std::vector<Chain> chains_;
    Eigen::VectorXd without_;  // displacements without the force of one chain
};

}  // namespace keyblock
