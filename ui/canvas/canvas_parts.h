// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What of a picture the canvas shows above the section, and the block that keeps a
// run from going on.
#pragma once

#include <QString>

namespace keyblock {

struct CanvasParts {
    bool marks = true, names = true, callOuts = true, ribbon = true, legend = true, scaleBar = true;

    bool operator==(const CanvasParts&) const = default;
};

/// Outlined, with a call-out.
struct Culprit {
    int block = -1;  // row of the solved blocks
    QString head, detail;  // "Block 143", "10 open–close iterations"

    bool operator==(const Culprit& other) const {
        return block == other.block && head == other.head && detail == other.detail;
    }
};

}  // namespace keyblock
