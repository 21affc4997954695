// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts of the operations spent on solving a step. Nothing is timed, so the same run
// gives the same counts on every machine.
#pragma once

namespace keyblock {

/// Number of operations of each kind that the solver has performed; `workOf` combines them into one measure.
struct StepWork {
    long factorizations = 0;  // factorisations made for a solve, in full or by rank updates
    long fullFactorizations = 0;
    long ranks = 0;  // sum of the ranks of all rank updates
    long solves = 0;  // back-substitutions
    long products = 0;  // matrix–vector products, and loops over all strains or forces
    long sweeps = 0;  // Gauss–Seidel sweeps over the contact forces, including the mixing of forces

    StepWork& operator+=(const StepWork& other) {
        factorizations += other.factorizations;
        fullFactorizations += other.fullFactorizations;
        ranks += other.ranks;
        solves += other.solves;
        products += other.products;
        sweeps += other.sweeps;
        return *this;
    }
    bool operator==(const StepWork&) const = default;
};

/// Total work in units of one full factorisation. Each operation is weighted by its cost in a model of a thousand
/// blocks.
inline double workOf(const StepWork& w) {
    return static_cast<double>(w.fullFactorizations) + 0.006 * static_cast<double>(w.ranks) +
           0.07 * static_cast<double>(w.solves) + 0.01 * static_cast<double>(w.products) +
           0.02 * static_cast<double>(w.sweeps);
}

}  // namespace keyblock
