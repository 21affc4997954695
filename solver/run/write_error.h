// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one failure that a run cannot turn into an outcome: the place where its
// results go takes no more. What was written before stays readable.
#pragma once

#include <stdexcept>

namespace keyblock {

/// A file or store cannot be written; `what()` says which, why, and what to do.
struct CannotWrite : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace keyblock
