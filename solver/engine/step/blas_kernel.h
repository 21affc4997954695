// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenBLAS chooses its kernels by the processor, and results of other kernels may differ
// in the last digits. Runs on several machines therefore agree on one of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// Environment variable that selects the kernel when a program starts.
inline constexpr const char* blasKernelVariable = "OPENBLAS_CORETYPE";

/// Name of the kernel that this process uses, e.g. `Haswell`.
std::string blasKernel();

/// Whether this processor has the instructions of a kernel. OpenBLAS does not check this.
bool canRunBlasKernel(std::string_view kernel);

/// A kernel that suits this processor, if the process uses one without AVX2 although the processor has it; otherwise
/// none.
std::optional<std::string> widerBlasKernel();

}  // namespace keyblock
