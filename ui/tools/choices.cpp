// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/choices.h"

#include "solver/files/scene/bolt_library.h"

namespace keyblock {
namespace {

template <typename Items>
QStringList namesOf(const Items& items) {
    QStringList names;
    for (const auto& item : items)
        if constexpr (requires { item.first; })
            names << QString::fromStdString(item.first);
        else
            names << QString::fromStdString(item.name);
    return names;
}

}  // namespace

QStringList materialNames(const Scene& scene) { return namesOf(scene.materials); }
QStringList jointMaterialNames(const Scene& scene) { return namesOf(scene.jointMaterials); }
QStringList regionNames(const Scene& scene) { return namesOf(scene.regions); }
QStringList stageNames(const Scene& scene) { return namesOf(scene.stages); }

QStringList boltTypeNames(const Scene& scene) {
    QStringList names;
    for (const BoltType& type : scene.boltTypes)
        if (!type.builtIn) names << QString::fromStdString(type.name);
    names += namesOf(builtInBoltTypes());
    names.removeDuplicates();
    return names;
}

void keepAmong(std::string& name, const QStringList& names) {
    if (!names.contains(QString::fromStdString(name))) name = names.isEmpty() ? "" : names.first().toStdString();
}

void keepAmong(std::optional<std::string>& name, const QStringList& names) {
    if (name && !names.contains(QString::fromStdString(*name))) name.reset();
}

}  // namespace keyblock
