// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/peak_memory.h"

#include <fstream>
#include <string>

namespace keyblock {

void resetPeakMemory() {
    std::ofstream file("/proc/self/clear_refs");
    file << "5";
}

double peakMemory() {
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;) {
        double kilobytes = 0.0;
        if (word == "VmHWM:" && file >> kilobytes) return 1024.0 * kilobytes;
    }
    return 0.0;
}

}  // namespace keyblock
