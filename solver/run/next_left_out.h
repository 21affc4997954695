// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the user could leave out of a scene next: what it costs and what it saves,
// where that has been measured.
#pragma once

#include "solver/engine/model/model.h"
#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

struct NextLeftOut {
    std::string axis;  // setting, named as on the axes of a trade, e.g. divisions
    std::string what;  // e.g. "divisions 120 → 60"
    std::string costs;  // e.g. "0.4 % in max B.axial_force, measured by 'trade'"
    std::string saves;  // e.g. "45 % of the time"
    std::string set;  // as for `--set`, several separated by spaces; empty: no single setting
    bool measured = false;
};

/// The candidates of a scene, not measured. \param scene as solved; \param model made from it.
std::vector<NextLeftOut> nextLeftOut(const Scene& scene, const Model& model);

/// One line on a candidate, e.g. "divisions 120 → 60: 0.4 % in max axial, measured by 'trade'; saves 45 % of the time".
std::string textOf(const NextLeftOut& next);

}  // namespace keyblock
