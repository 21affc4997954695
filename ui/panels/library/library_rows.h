// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of the bolt library: types grouped by class, every value with its source,
// and the steel and bond laws as curves. Plain values for the panel.
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <vector>

namespace keyblock {

class Display;

struct LibraryEntry {
    BoltType type;
    QString group;  // the class of the bolt, or a group for the types of the scene
    QString detail;
    int users = 0;  // number of bolts and patterns of the scene that use this type
};

/// Bolt types whose name, class or source contains `filter`: first the types of the scene, then the built-in types by
/// class.
std::vector<LibraryEntry> libraryEntries(const Scene& scene, const Display& display, const QString& filter);

struct LibraryNumber {
    QString heading, label, value, source;
    bool unconfirmed = false;  // the source is marked as unconfirmed or as an estimate
};

/// All values that apply to the bolt type, with their sources.
std::vector<LibraryNumber> libraryNumbers(const BoltType& type, const Display& display);

/// A curve in display units, with axis titles that include the units.
struct ShownCurve {
    QString title;
    Table points;
    QString across, up;
};

/// Stress–strain curve of the steel; has no points if the steel is linear elastic and cannot break.
ShownCurve steelCurve(const BoltType& type, const Display& display);

/// Force–slip curves of the bond laws of the bolt type; identical laws are shown only once.
std::vector<ShownCurve> bondCurves(const BoltType& type, const Display& display);

/// Force–slip curve of an anchor according to its bond law, up to the slip `farthest` [m]. If the law is given by
/// points, the points are returned unchanged.
Table bondCurve(const Anchor& anchor, double farthest);

}  // namespace keyblock
