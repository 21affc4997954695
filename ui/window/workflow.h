// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// State of each workflow step, derived from the scene and its problems.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <QMetaType>

#include <array>
#include <span>

namespace keyblock {

enum class WorkStep { Geometry, Materials, Support, Stages, Run, Results, Studies };
inline constexpr std::size_t workSteps = 7;

enum class WorkState { Nothing, NotYet, Done, Warning, Error, Running };  // Nothing: no mark

using WorkStates = std::array<WorkState, workSteps>;

/// The workflow step to which a problem belongs. \param pointer JSON pointer to the part of the scene with the problem.
WorkStep stepOf(const std::string& pointer);

/// States of the first four steps. The states of the others depend on runs and are set elsewhere.
WorkStates workStates(const Scene& scene, std::span<const Problem> problems);

}  // namespace keyblock

Q_DECLARE_METATYPE(keyblock::WorkStep)
