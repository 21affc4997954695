// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/blas_kernel.h"

#include <algorithm>
#include <array>

extern "C" char* openblas_get_corename();

namespace keyblock {
namespace {

template <std::size_t count>
[[maybe_unused]] bool isOneOf(std::string_view name, const std::array<std::string_view, count>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::string blasKernel() { return openblas_get_corename(); }

bool canRunBlasKernel([[maybe_unused]] std::string_view kernel) {
#if defined(__x86_64__)
    constexpr std::array<std::string_view, 3> wide{"SkylakeX", "Cooperlake", "SapphireRapids"};
    constexpr std::array<std::string_view, 3> fused{"Haswell", "Zen", "Excavator"};
    constexpr std::array<std::string_view, 4> avx{"Sandybridge", "Bulldozer", "Piledriver", "Steamroller"};
    if (isOneOf(kernel, wide)) return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl");
    if (isOneOf(kernel, fused)) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (isOneOf(kernel, avx)) return __builtin_cpu_supports("avx");
#endif
    return true;
}

}  // namespace keyblock
