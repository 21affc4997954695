// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Problems that can be fixed with one click: the text of the link and the edit that it
// applies.
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
    QString text;  // text of the link and name of the undo step
    std::function<Edit(const Scene&)> edit;
};

/// The remedy for a problem; none if the user has to decide what to do.
std::optional<Remedy> remedyFor(const Scene& scene, const Problem& problem);

/// Blocks that the default cutting limits would have merged, but that exist because the scene sets smaller limits.
struct Slivers {
    int count = 0;
    double area = 0.0;  // total area [m²]
    double width = 0.0;  // default limit of the block width [m]
    Box box{};  // bounding box of all slivers
};
Slivers sliversOf(const Scene& scene, const SceneCut& cut);

/// Remedy that restores the default cutting limits, so that the slivers are merged.
Remedy mergeSlivers(const Slivers& slivers);

}  // namespace keyblock
