// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with a requested file, as one message.
#pragma once

#include <stdexcept>

namespace keyblock {

/// A file is missing, is not what it was taken for, or is damaged; `what()` says which, why, and what to do.
struct CannotRead : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace keyblock
