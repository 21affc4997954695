// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exception for files that cannot be read.
#pragma once

#include <stdexcept>

namespace keyblock {

/// Thrown if a file is missing, of the wrong kind or damaged; `what()` gives its path, the reason and a remedy.
struct CannotRead : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace keyblock
