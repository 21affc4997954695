// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/blas_choice.h"

#include "solver/engine/step/blas_kernel.h"
#include "solver/files/read_error.h"

#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

namespace keyblock::cli {

namespace {

/// Arguments of this process, the program's name first.
std::vector<std::string> ownArguments() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    const std::string all(std::istreambuf_iterator<char>(file), {});
    std::vector<std::string> words;
    for (std::size_t from = 0; from < all.size();) {
        const std::size_t end = std::min(all.find('\0', from), all.size());
        words.push_back(all.substr(from, end - from));
        from = end + 1;
    }
    return words;
}

/// Starts the program again with a variable of the environment. Returns only if that cannot be done.
void startAgainWith(const char* variable, const char* value) {
    ::setenv(variable, value, 1);
    std::vector<std::string> words = ownArguments();
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv("/proc/self/exe", pointers.data());
}

}  // namespace

void useBlasKernel(const std::string& kernel) {
    if (blasKernel() == kernel) return;
    const char* chosen = ::getenv(blasKernelVariable);
    if (canRunBlasKernel(kernel) && !(chosen && kernel == chosen)) startAgainWith(blasKernelVariable, kernel.c_str());
    throw CannotRead("the sweep was planned with the OpenBLAS kernel " + kernel +
                     ", which this machine cannot use; plan it with a kernel that all machines have, e.g. "
                     "OPENBLAS_CORETYPE=Haswell keyblock sweep plan");
}

void avoidBlasThreads() {
    constexpr const char* threads = "OPENBLAS_NUM_THREADS";
    rlimit space{};
    if (::getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return;
    const char* chosen = ::getenv(threads);
    if (!chosen || std::string_view(chosen) != "1") startAgainWith(threads, "1");
}

}  // namespace keyblock::cli
