// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of a scene that options of tools choose from.
#pragma once

#include "solver/scene/scene.h"

#include <QStringList>

namespace keyblock {

QStringList materialNames(const Scene& scene);
QStringList jointMaterialNames(const Scene& scene);
QStringList regionNames(const Scene& scene);
QStringList boltTypeNames(const Scene& scene);  // the scene's own, then the built-in ones
QStringList stageNames(const Scene& scene);

/// A name that does not exist in this scene becomes the first one, or none.
void keepAmong(std::string& name, const QStringList& names);
void keepAmong(std::optional<std::string>& name, const QStringList& names);

}  // namespace keyblock
