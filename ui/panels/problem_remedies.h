// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Problems that can be fixed by one click: the text of the link and the edit.
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
    QString text;  // of the link, also the name of the undo step
    std::function<Edit(const Scene&)> edit;
};

/// None if the user has to decide.
std::optional<Remedy> remedyFor(const Scene& scene, const Problem& problem);

/// Blocks that the default cutting limits would have merged, if the scene sets smaller limits.
struct Slivers {
    int count = 0;
    double area = 0.0;  // of all [m²]
    double width = 0.0;  // limit of their width [m]
    Box box{};  // bounding box of all
};
Slivers sliversOf(const Scene& scene, const SceneCut& cut);

/// Restores the default cutting limits.
Remedy mergeSlivers(const Slivers& slivers);

}  // namespace keyblock
