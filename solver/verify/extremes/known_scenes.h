// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes with a known answer, each with the check of its answer. The checks use closed
// forms and invariants only, and no code of the solver.
#pragma once

#include "solver/verify/extremes/conditions.h"
#include "solver/verify/extremes/findings.h"
#include "solver/verify/readings.h"

#include <string>
#include <vector>

namespace keyblock {

struct KnownScene {
    std::string name;
    std::string shows;  // the scene, in one line
    std::string property;  // what its answer is checked against
    Conditions usual;  // ordinary conditions
    std::vector<std::string> axes;  // names of the axes along which it is pushed
    Scene (*scene)(const Conditions&);  // in its own axes
    void (*judge)(const Conditions&, const Solved&, Findings&);
    /// Whether the closed form applies; null: always. Random combinations are drawn again where it does not.
    bool (*applies)(const Conditions&) = nullptr;
};

std::vector<KnownScene> restingScenes();
std::vector<KnownScene> movingScenes();
std::vector<KnownScene> boltedScenes();
std::vector<KnownScene> dividedScenes();

}  // namespace keyblock
