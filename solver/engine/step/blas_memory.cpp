// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/blas_memory.h"

#include <sys/mman.h>

#include <cstddef>
#include <new>

extern "C" void dpotrf_(const char* triangle, const int* n, double* a, const int* stride, int* info);

namespace keyblock {
namespace {

constexpr std::size_t bufferSize = (std::size_t{128} << 20) +
                                   (std::size_t{1} << 20);  // and a little for its own use [bytes]

bool isAvailable(std::size_t size) {
    void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return false;
    ::munmap(memory, size);
    return true;
}

/// OpenBLAS takes its buffer for the first matrix, however small.
bool take() {
    if (!isAvailable(bufferSize)) throw std::bad_alloc();
    const int one = 1;
    double value = 1.0;
    int info = 0;
    dpotrf_("L", &one, &value, &one, &info);
    return true;
}

}  // namespace

bool hasBlasMemory(std::size_t threads) { return isAvailable(threads * bufferSize); }

void reserveBlasMemory() { [[maybe_unused]] static const bool taken = take(); }

}  // namespace keyblock
