// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The links that sweeps over contact forces go through, one compact row each in the
// order of the sweep: all that a visit reads lies together. The unknowns of a body are
// scaled by the Cholesky factor L of its own stiffness, x = Lᵀ·d, in which a force
// moves the body along the same vector that gives the strain, so that a row has one
// vector instead of two.
#pragma once

#include "solver/engine/step/flat_law.h"
#include "solver/engine/step/link_rows.h"

#include <array>
#include <vector>

namespace keyblock {

class SweptLinks {
public:
    /// Squares of the forces and of their changes, summed over a sweep.
    struct Change {
        double changed = 0.0, forces = 0.0;
    };

    /// Takes the links between blocks; those of bolt nodes and those without stiffness are left out.
    SweptLinks(StepProblem& problem, const LinkRows& rows);

    /// True where every block can be moved by its own stiffness alone, which sweeps need.
    bool possible() const { return possible_; }

    std::size_t count() const { return rows_.size(); }

    /// Link of the problem in row n.
    std::size_t linkOf(std::size_t n) const { return rows_[n].link; }

    /// Sets the force that stays the same during the sweeps (padded).
    void hold(const Eigen::VectorXd& outer);

    /// Limits the forces, one per row and before shares, to what their laws can give [N].
    void clip(std::vector<double>& forces);

    /// The same, and moves the blocks to where they balance under these forces.
    void clipAndPlace(std::vector<double>& forces);

    /// Limits the forces and moves the blocks by what that changes.
    /// \pre the blocks have been placed under these forces.
    void clipPlaced(std::vector<double>& forces);

    /// Scaled displacements of the blocks, which depend linearly on the forces.
    Eigen::VectorXd& placed() { return moved_; }

    /// Sets every force to what its law gives where the blocks yield to it, one after the other.
    /// \param changes of the forces, one per row.
    /// \pre the blocks have been placed under these forces.
    Change sweep(std::vector<double>& forces, Eigen::VectorXd& changes);

    /// Friction limit of row n under these forces [N].
    double limit(std::size_t n, const std::vector<double>& forces) const;

    /// Strain at which the law of row n gives its force; for a law that is flat there, any.
    double strain(std::size_t n, double force) const;

    /// Tangent of the law of row n there, where it neither slides nor stands open.
    double tangent(std::size_t n) const;

private:
    struct Row {
        std::array<double, 12> gradient{};  // scaled, six entries for either body
        double start = 0.0;  // strain at no scaled displacement
        double share = 1.0;
        double compliance = 0.0;  // strain per unit of force
        FlatLaw law;
        int firstA = 0, firstB = 0;  // unknowns
        int pair = -1;  // row of limitPairs; −1: none
        std::size_t link = 0;
    };
    struct Bounds {
        double low = 0.0, high = 0.0;
    };

    void scaleBlocks();
    void addRow(std::size_t link, int pair);
    void scaleGradient(Row& row) const;
    void move(const Row& row, double force);
    Bounds bounds(std::size_t n, const std::vector<double>& forces) const;
    Bounds bentBounds(std::size_t n, const std::vector<double>& forces) const;
    double bentForce(const Row& row, double free, double force);

    StepProblem& problem_;
    const LinkRows& links_;
    bool possible_ = true;
    std::vector<Matrix6> scales_;  // per block: L⁻¹; columns of prescribed unknowns are zero
    std::vector<Row> rows_;  // a normal force before its friction
    std::vector<double> bentStrains_;  // per row
    Eigen::VectorXd driven_;  // prescribed displacements (padded)
    Eigen::VectorXd held_, moved_;  // scaled displacements under the outer force alone, and under all (padded)
};

}  // namespace keyblock
