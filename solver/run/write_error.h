// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one failure that a run cannot report as an outcome: its results can no longer
// be written. Results written before remain readable.
#pragma once

#include <stdexcept>

namespace keyblock {

/// Thrown if a file or store cannot be written; `what()` gives its path, the reason and a remedy.
struct CannotWrite : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace keyblock
