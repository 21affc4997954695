// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block that is outlined and has a call-out: one that limits the convergence of a
// run, or one that the user wants to see.
#pragma once

#include <QString>

namespace keyblock {

/// The highlighted block and the text of its call-out.
struct HighlightedBlock {
    int block = -1;  // index among the solved blocks
    QString head, detail;  // "Block 143", "10 open–close iterations"

    bool operator==(const HighlightedBlock&) const = default;
};

}  // namespace keyblock
