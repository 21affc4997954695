// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenBLAS reads the choice of its kernel from the environment when a program starts, so
// the program starts itself again where it has to use another one.
#pragma once

#include <string>

namespace keyblock::cli {

/// Continues with this kernel: returns if it is in use, otherwise starts the program again with the same arguments.
/// \throws CannotRead if this processor cannot run the kernel
void useBlasKernel(const std::string& kernel);

}  // namespace keyblock::cli
