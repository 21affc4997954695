// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small scene and made-up results for it, with every kind of value that tables
// and stores must carry. No mechanics: the numbers only have to be distinguished.
#pragma once

#include "solver/results/results.h"
#include "solver/run/sink.h"
#include "solver/scene/scene.h"

namespace keyblock::test {

/// Two blocks (the second without a name), one bolt of a type of its own, three monitors, two stages.
Scene sampleScene();

/// Two frames a stage; in the first stage one debonding and one joint event at the same time.
Results sampleResults();

/// Hands the results to a sink in the order in which a run does.
void feed(const Scene& scene, const Results& results, Sink& sink);

}  // namespace keyblock::test
