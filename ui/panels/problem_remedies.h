// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Problems that one click can mend: what the link says, and the edit behind it.
#pragma once

#include "geometry/polygon.h"
#include "solver/scene/problem.h"
#include "solver/scene/scene_cut.h"

#include <QString>

#include <functional>
#include <optional>

namespace keyblock {

struct Edit;

struct Remedy {
    QString text;  // of the link, also the name of the step
    std::function<Edit(const Scene&)> edit;
};

/// None where a person has to decide.
std::optional<Remedy> remedyFor(const Scene& scene, const Problem& problem);

/// Blocks that the default limits of the cut would have merged, where the scene asks for smaller limits.
struct Slivers {
    int count = 0;
    double area = 0.0;  // of all [m²]
    double width = 0.0;  // they are narrower than this [m]
    Box box{};  // round all
};
Slivers sliversOf(const Scene& scene, const SceneCut& cut);

/// Gives the cut its default limits back.
Remedy mergeSlivers(const Slivers& slivers);

}  // namespace keyblock
