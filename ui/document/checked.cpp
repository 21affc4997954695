// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/checked.h"

#include <exception>
#include <optional>

namespace keyblock {

// Exceptions of a check (out of memory, for example) are reported as problems and do not end the program.
std::shared_ptr<const Checked> checkedOf(const std::shared_ptr<const Scene>& scene,
                                         const std::atomic<bool>* stop) {
    auto checked = std::make_shared<Checked>();
    checked->scene = scene;
    try {
        std::optional<SceneCut> cut;
        checked->problems = checkScene(*scene, &cut, stop);
        if (stop && *stop) return checked;
        if (cut) checked->cut = std::make_shared<const SceneCut>(std::move(*cut));
        const Scene& solved = checked->cut ? checked->cut->scene : *scene;
        if (!hasErrors(checked->problems) && !solved.blocks.empty())
            checked->picture = std::make_shared<const SectionPicture>(drawingPicture(solved));
    } catch (const std::exception& error) {
        checked->problems.push_back({Severity::Error, {}, 0, {}, std::string("the check failed: ") + error.what(),
                                     "undo the last edit, or reduce the size of the scene"});
    }
    return checked;
}

}  // namespace keyblock
