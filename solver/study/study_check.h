// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of a study that need its scene: paths that exist, distributions that stay
// in the range of their field, names of bolts and quantities.
#pragma once

#include "solver/files/scene/scene_file.h"
#include "solver/scene/problem.h"
#include "solver/study/study.h"

#include <string>
#include <vector>

namespace keyblock {

/// Problems of a study whose single values have been checked, with pointers but without file and line.
/// \param read its scene, which has been read.
/// \param sceneText the text of the scene.
std::vector<Problem> checkStudy(const Study& study, const SceneReading& read, const std::string& sceneText);

}  // namespace keyblock
