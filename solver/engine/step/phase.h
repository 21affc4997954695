// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks which part of a step is being worked on, so that a benchmark can tell where the
// time goes. Nothing in the solver reads the mark.
#pragma once

namespace keyblock {

enum class Phase {
    Other,
    Search,  // contacts
    Build,  // problem, links, matrix pattern
    Judge,  // forces, balance, line search, products
    Sweep,  // sweeps over the contact forces
    Assemble,  // matrix
    Factor,  // full factorization
    Update,  // of a factor by ranks
    Solve,  // back-substitution
    Accept  // energies, new state
};

inline constexpr int phases = 10;

/// The phase on which the thread works. Volatile, because a benchmark reads it from a signal handler.
inline thread_local volatile Phase currentPhase = Phase::Other;

/// Marks a scope as part of a phase, apart from scopes within it that mark another.
class PhaseScope {
public:
    explicit PhaseScope(Phase phase) : before_(currentPhase) { currentPhase = phase; }
    ~PhaseScope() { currentPhase = before_; }
    PhaseScope(const PhaseScope&) = delete;
    PhaseScope& operator=(const PhaseScope&) = delete;

private:
    Phase before_;
};

}  // namespace keyblock
