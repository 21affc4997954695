// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/start/blas_choice.h"

#include "solver/engine/step/blas_kernel.h"
#include "solver/files/read_error.h"

#include <stdlib.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

namespace keyblock {

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

/// Starts the program again with the present environment. Returns only if that cannot be done.
void startAgain() {
    std::vector<std::string> words = ownArguments();
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv("/proc/self/exe", pointers.data());
}

/// \return true if the variable had another value.
bool set(const char* variable, const std::string& value) {
    const char* before = ::getenv(variable);
    if (before && value == before) return false;
    ::setenv(variable, value.c_str(), 1);
    return true;
}

}  // namespace

void useBlasKernel(const std::string& kernel) {
    if (blasKernel() == kernel) return;
    if (canRunBlasKernel(kernel) && set(blasKernelVariable, kernel)) startAgain();
    throw CannotRead("the sweep was planned with the OpenBLAS kernel " + kernel +
                     ", which this machine cannot use; plan it with a kernel that all machines have, e.g. "
                     "OPENBLAS_CORETYPE=Haswell keyblock sweep plan");
}

void chooseBlas() {
    const std::optional<std::string> kernel = widerBlasKernel();
    const bool another = kernel && !::getenv(blasKernelVariable) && set(blasKernelVariable, *kernel);
    const bool single = set("OPENBLAS_NUM_THREADS", "1");
    if (another || single) startAgain();
}

}  // namespace keyblock
