// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/stored_scene.h"

#include "solver/files/scene/scene_file.h"
#include "solver/files/run_store/store_reading.h"

#include <utility>

namespace keyblock {

Scene storedScene(const std::filesystem::path& store) {
    using namespace store_reading;
    const sqlite::Database database = opened(store);
    try {
        requireRunStore(database, store);
        SceneReading reading = readSceneText(aboutValue(database, "scene"), store.string() + " (scene)", {},
                                             std::nullopt);
        if (!reading.scene) cannotRead(store, "this program does not accept the scene in it; run the scene again");
        return std::move(*reading.scene);
    } catch (const sqlite::Error&) {
        cannotRead(store, damaged);
    }
}

}  // namespace keyblock
