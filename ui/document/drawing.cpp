// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stages are set aside: what comes and goes with them is drawn as there, so that it
// can be seen and pointed at.
#include "ui/document/drawing.h"

#include "solver/run/as_drawn.h"

namespace keyblock {

SectionPicture drawingPicture(const Scene& solved) {
    if (solved.blocks.empty()) return {};
    Scene scene = solved;
    scene.stages = {Stage{}};
    Results results;
    results.frames.push_back(frameAsDrawn(scene));
    SectionRequest request;
    request.frame = 0;
    request.whole = true;
    return sectionPicture(MemoryRun(scene, results), request);
}

}  // namespace keyblock
