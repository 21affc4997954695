// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of objects of a scene, offered as choices in the options of tools.
#pragma once

#include "solver/scene/scene.h"

#include <QStringList>

namespace keyblock {

QStringList materialNames(const Scene& scene);
QStringList jointMaterialNames(const Scene& scene);
QStringList regionNames(const Scene& scene);
QStringList boltTypeNames(const Scene& scene);  // types of the scene first, then the built-in ones
QStringList stageNames(const Scene& scene);

/// Leaves `name` unchanged if it is one of `names`. Otherwise the first overload sets `name` to the first of `names`,
/// or to an empty string if `names` is empty; the second overload resets `name`.
void keepAmong(std::string& name, const QStringList& names);
void keepAmong(std::optional<std::string>& name, const QStringList& names);

}  // namespace keyblock
