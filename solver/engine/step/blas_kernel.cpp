// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/blas_kernel.h"

#include <algorithm>
#include <array>

extern "C" char* openblas_get_corename();

namespace keyblock {
namespace {

// By the widest instructions that the kernels need: AVX-512, AVX2, AVX
constexpr std::array<std::string_view, 3> wide{"SkylakeX", "Cooperlake", "SapphireRapids"};
constexpr std::array<std::string_view, 3> fused{"Haswell", "Zen", "Excavator"};
[[maybe_unused]] constexpr std::array<std::string_view, 4> avx{"Sandybridge", "Bulldozer", "Piledriver", "Steamroller"};

template <std::size_t count>
bool isOneOf(std::string_view name, const std::array<std::string_view, count>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool hasAvx512() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl");
#else
    return false;
#endif
}

bool hasAvx2() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

}  // namespace

std::string blasKernel() { return openblas_get_corename(); }

bool canRunBlasKernel(std::string_view kernel) {
    if (isOneOf(kernel, wide)) return hasAvx512();
    if (isOneOf(kernel, fused)) return hasAvx2();
#if defined(__x86_64__)
    if (isOneOf(kernel, avx)) return __builtin_cpu_supports("avx");
#endif
    return true;
}

std::optional<std::string> widerBlasKernel() {
    const std::string used = blasKernel();
    if (!hasAvx2() || isOneOf(used, wide) || isOneOf(used, fused)) return std::nullopt;
    return hasAvx512() ? "SkylakeX" : "Haswell";
}

}  // namespace keyblock
