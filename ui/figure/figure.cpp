// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/figure.h"

#include "ui/figure/bolt_figure.h"
#include "ui/figure/curves_figure.h"
#include "ui/figure/events_figure.h"
#include "ui/figure/section_figure.h"

namespace keyblock {

Figure paintFigure(const RunSource& run, const FigureRequest& request) {
    switch (request.kind) {
        case FigureKind::Section: return paintSection(run, request);
        case FigureKind::Bolt: return paintBolt(run, request);
        case FigureKind::Curves: return paintCurves(run, request);
        case FigureKind::Events: return paintEvents(run, request);
    }
    throw CannotDraw("there is no such figure");
}

}  // namespace keyblock
