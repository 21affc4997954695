// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenBLAS reads the choice of its kernel and of its threads from the environment when a
// program starts, so the program starts itself again where it has to use another one.
#pragma once

#include <string>

namespace keyblock::cli {

/// Continues with this kernel: returns if it is in use, otherwise starts the program again with the same arguments.
/// \throws CannotRead if this processor cannot run the kernel
void useBlasKernel(const std::string& kernel);

/// Continues without threads of OpenBLAS if the address space is limited (`ulimit -v`): starts the program again unless
/// there are none. Such a thread asks for a buffer of 128 MB, again and again where it does not get it, and may take it
/// from the main thread, which then waits forever. The program itself uses OpenBLAS on one thread.
void avoidBlasThreads();

}  // namespace keyblock::cli
