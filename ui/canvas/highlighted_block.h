// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block outlined with a call-out: one that limits the convergence of a run, or one
// that the user asked to see.
#pragma once

#include <QString>

namespace keyblock {

/// Outlined, with a call-out.
struct HighlightedBlock {
    int block = -1;  // row of the solved blocks
    QString head, detail;  // "Block 143", "10 open–close iterations"

    bool operator==(const HighlightedBlock&) const = default;
};

}  // namespace keyblock
