// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verify/reference/voussoir.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <vector>

namespace keyblock::reference {

namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// Stiffness of a square of side 1 and thickness 1, corners counter-clockwise from (0, 0), by two Gauss points a way.
/// In the plane it does not depend on the side.
Matrix8 squareStiffness(double youngsModulus, double nu) {
    Eigen::Matrix3d elasticity;
    elasticity << 1.0, nu, 0.0, nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - nu);
    elasticity *= youngsModulus / (1.0 - nu * nu);
    const double gauss[] = {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
    Matrix8 stiffness = Matrix8::Zero();
    for (const double x : gauss)
        for (const double y : gauss) {
            const double dx[] = {-(1.0 - y), 1.0 - y, y, -y}, dy[] = {-(1.0 - x), -x, x, 1.0 - x};
            Eigen::Matrix<double, 3, 8> strain = Eigen::Matrix<double, 3, 8>::Zero();
            for (int n = 0; n < 4; ++n) {
                strain(0, 2 * n) = strain(2, 2 * n + 1) = dx[n];
                strain(1, 2 * n + 1) = strain(2, 2 * n) = dy[n];
            }
            stiffness += 0.25 * strain.transpose() * elasticity * strain;
        }
    return stiffness;
}

/// The left half: x from the abutment at 0 to the middle.
class HalfBeam {
public:
    HalfBeam(const VoussoirBeam& beam, int rows)
        : rows_(rows), columns_(static_cast<int>(std::lround(0.5 * beam.span / beam.depth * rows))),
          side_(beam.depth / rows), touches_(2 * static_cast<std::size_t>(rows + 1), 1) {
        assemble(beam);
    }

    VoussoirThrust solve() {
        VoussoirThrust found;
        do {
            ++found.rounds;
            balance();
        } while (judge() && found.rounds < 200);
        double ends[] = {0.0, 0.0}, moments[] = {0.0, 0.0};
        for (int end : {0, 1})
            for (int row = 0; row <= rows_; ++row) {
                ends[end] += push(end, row);
                moments[end] += push(end, row) * row * side_;
            }
        found.thrust = ends[1];
        found.arm = moments[1] / ends[1] - moments[0] / ends[0];
        return found;
    }

private:
    int node(int column, int row) const { return column * (rows_ + 1) + row; }
    int atEnd(int end, int row) const { return 2 * node(end * columns_, row); }  // its x
    char& touches(int end, int row) { return touches_[end * (rows_ + 1) + row]; }

    void assemble(const VoussoirBeam& beam) {
        const Matrix8 element = squareStiffness(beam.youngsModulus, beam.poissonsRatio);
        const int unknowns = 2 * (columns_ + 1) * (rows_ + 1);
        load_ = Eigen::VectorXd::Zero(unknowns);
        std::vector<Eigen::Triplet<double>> entries;
        for (int column = 0; column < columns_; ++column)
            for (int row = 0; row < rows_; ++row) {
                const int corners[] = {node(column, row), node(column + 1, row), node(column + 1, row + 1),
                                       node(column, row + 1)};
                for (int i = 0; i < 8; ++i)
                    for (int j = 0; j < 8; ++j)
                        entries.emplace_back(2 * corners[i / 2] + i % 2, 2 * corners[j / 2] + j % 2, element(i, j));
                for (const int corner : corners) load_[2 * corner + 1] -= 0.25 * beam.unitWeight * side_ * side_;
            }
        stiffness_.resize(unknowns, unknowns);
        stiffness_.setFromTriplets(entries.begin(), entries.end());
        moves_ = Eigen::VectorXd::Zero(unknowns);
    }

    /// Nodes that touch the abutment stay where they are; those that touch in the middle stay on the line of symmetry.
    void balance() {
        std::vector<char> held(load_.size(), 0);
        for (int row = 0; row <= rows_; ++row) {
            if (touches(0, row))
                held[atEnd(0, row)] = held[atEnd(0, row) + 1] = 1;
            if (touches(1, row)) held[atEnd(1, row)] = 1;
        }
        Eigen::SparseMatrix<double> free = stiffness_;
        const auto isHeld = [&](Eigen::Index i) { return held[i] != 0; };
        free.prune([&](Eigen::Index i, Eigen::Index j, double) { return i == j || (!isHeld(i) && !isHeld(j)); });
        Eigen::VectorXd right = load_;
        for (Eigen::Index i = 0; i < right.size(); ++i)
            if (isHeld(i)) right[i] = 0.0;
        moves_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(free).solve(right);
        reactions_ = stiffness_ * moves_ - load_;
    }

    /// What an end presses on the node [N].
    double push(int end, int row) const {
        return (end == 0 ? 1.0 : -1.0) * reactions_[atEnd(end, row)];
    }

    /// Nodes that are pulled open, and open ones that went through close. \return true where any did
    bool judge() {
        bool changed = false;
        for (int end : {0, 1})
            for (int row = 0; row <= rows_; ++row) {
                const double inside = (end == 0 ? -1.0 : 1.0) * moves_[atEnd(end, row)];
                const bool now = touches(end, row) ? push(end, row) > 0.0 : inside > 0.0;
                changed = changed || now != (touches(end, row) != 0);
                touches(end, row) = now;
            }
        return changed;
    }

    int rows_, columns_;
    double side_;
    std::vector<char> touches_;  // a row per end and node
    Eigen::SparseMatrix<double> stiffness_;
    Eigen::VectorXd load_, moves_, reactions_;
};

}  // namespace

VoussoirThrust voussoirThrust(const VoussoirBeam& beam, int rows) { return HalfBeam(beam, rows).solve(); }

}  // namespace keyblock::reference
