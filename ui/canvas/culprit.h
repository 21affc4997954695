// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The block that keeps a run from going on, or that a person asked for.
#pragma once

#include <QString>

namespace keyblock {

/// Outlined, with a call-out.
struct Culprit {
    int block = -1;  // row of the solved blocks
    QString head, detail;  // "Block 143", "10 open–close iterations"

    bool operator==(const Culprit&) const = default;
};

}  // namespace keyblock
