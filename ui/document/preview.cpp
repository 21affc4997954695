// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stages are ignored: everything that a stage excavates, installs or removes is
// drawn, so that it can be seen and picked.
#include "ui/document/preview.h"

#include "solver/run/preview_frame.h"

namespace keyblock {

SectionPicture drawingPicture(const Scene& solved) {
    if (solved.blocks.empty()) return {};
    Scene scene = solved;
    scene.stages = {Stage{}};
    Results results;
    results.frames.push_back(previewFrame(scene));
    SectionRequest request;
    request.frame = 0;
    request.whole = true;
    return sectionPicture(MemoryRun(scene, results), request);
}

}  // namespace keyblock
