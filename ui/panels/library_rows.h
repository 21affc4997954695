// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of the bolt library: types by class, each value with its source, steel
// and bond laws as curves. Plain values for the panel.
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <vector>

namespace keyblock {

class Display;

struct LibraryEntry {
    BoltType type;
    QString group;  // types of the scene, or the bolt class
    QString detail;
    int users = 0;  // number of bolts and patterns of the scene
};

/// The scene's own types first, then the built-in ones by class, if `filter` is in their name, class or source.
std::vector<LibraryEntry> libraryEntries(const Scene& scene, const Display& display, const QString& filter);

struct LibraryNumber {
    QString heading, label, value, source;
    bool unconfirmed = false;  // not confirmed by a source
};

/// Every value of the type that applies, with its source.
std::vector<LibraryNumber> libraryNumbers(const BoltType& type, const Display& display);

/// A curve as shown: titles with units.
struct ShownCurve {
    QString title;
    Table points;
    QString across, up;
};

/// Strain and stress of the steel; without points for steel that is linear and unbreakable.
ShownCurve steelCurve(const BoltType& type, const Display& display);

/// Slip and force of each different bond law of the type.
std::vector<ShownCurve> bondCurves(const BoltType& type, const Display& display);

/// Force of an anchor for a slip up to `farthest` [m]: the bond law by itself.
Table bondCurve(const Anchor& anchor, double farthest);

}  // namespace keyblock
