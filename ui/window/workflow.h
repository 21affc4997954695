// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress of the workflow, step by step, from the scene and its problems.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <QMetaType>

#include <array>
#include <span>

namespace keyblock {

enum class WorkStep { Geometry, Materials, Support, Stages, Run, Results };
inline constexpr std::size_t workSteps = 6;

enum class WorkState { Nothing, NotYet, Done, Warning, Error, Running };  // Nothing: no mark

using WorkStates = std::array<WorkState, workSteps>;

/// The step that a problem belongs to, by its pointer.
WorkStep stepOf(const std::string& pointer);

/// States of the first four steps; those of Run and Results come from the runs.
WorkStates workStates(const Scene& scene, std::span<const Problem> problems);

}  // namespace keyblock

Q_DECLARE_METATYPE(keyblock::WorkStep)
