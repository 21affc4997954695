// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenBLAS reads the choice of its kernel and of its threads from the environment when a
// program starts, so the program starts itself again where it has to use another one.
#pragma once

#include <string>

namespace keyblock {

/// Continues with this kernel: returns if it is in use, otherwise starts the program again with the same arguments.
/// \throws CannotRead if this processor cannot run the kernel
void useBlasKernel(const std::string& kernel);

/// Continues with a kernel that suits the processor and without threads of OpenBLAS: starts the program again, once,
/// unless this is so. To be called first in `main`.
///
/// OpenBLAS knows processors by their model. On one that it does not know it takes a kernel without AVX, with which rock
/// in motion takes up to a third longer. A kernel that the user has chosen (`OPENBLAS_CORETYPE`) is kept.
///
/// The program uses OpenBLAS on one thread. Each further thread of OpenBLAS would spend a tenth of a second of CPU time
/// waiting for work. It would also allocate a buffer of 128 MB. Where memory is limited (`ulimit -v`) it would try again
/// and again, and could leave none for the main thread, which would then wait forever.
void chooseBlas();

}  // namespace keyblock
