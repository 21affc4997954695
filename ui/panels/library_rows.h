// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolt library in words: types by the way they hold, each number with its
// source, steel and bonds as curves. Plain values for the panel.
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <vector>

namespace keyblock {

class Display;

struct LibraryEntry {
    BoltType type;
    QString group;  // of the scene, or the way it holds
    QString detail;
    int users = 0;  // bolts and patterns of the scene
};

/// The scene's own types first, then the built-in ones by class; those that hold `filter` in name, class, or source.
std::vector<LibraryEntry> libraryEntries(const Scene& scene, const Display& display, const QString& filter);

struct LibraryNumber {
    QString heading, label, value, source;
    bool unconfirmed = false;  // no source at hand confirms it
};

/// Every number of the type that says something, with where it comes from.
std::vector<LibraryNumber> libraryNumbers(const BoltType& type, const Display& display);

/// A curve as shown: titles with units.
struct ShownCurve {
    QString title;
    Table points;
    QString across, up;
};

/// Strain and stress of the steel; without points for steel that is linear and unbreakable.
ShownCurve steelCurve(const BoltType& type, const Display& display);

/// Slip and force of each way in which the type is anchored, the same ones once.
std::vector<ShownCurve> bondCurves(const BoltType& type, const Display& display);

/// What an anchor holds while it slips up to `farthest` [m]: the law without rock around it.
Table bondCurve(const Anchor& anchor, double farthest);

}  // namespace keyblock
