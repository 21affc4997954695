// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenBLAS needs a large buffer and asks for it again and again, without end, where the
// system does not give it. It is therefore asked for here first.
#pragma once

#include <cstddef>

namespace keyblock {

/// Makes OpenBLAS take its buffer now; it then keeps it. Later calls do nothing.
/// \throws std::bad_alloc if there is not enough memory for it.
void reserveBlasMemory();

/// True if the system gives as much memory as OpenBLAS needs for `threads` threads at once.
bool hasBlasMemory(std::size_t threads);

}  // namespace keyblock
