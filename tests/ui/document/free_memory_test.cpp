// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a thread has freed goes back to the system although some of its blocks are kept.
#include "ui/document/free_memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <thread>
#include <vector>

namespace keyblock {
namespace {

double residentBytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0, resident = 0.0;
    file >> pages >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

TEST(FreeMemory, IsReturnedFromBetweenBlocksThatAreKept) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers have an allocator of their own";
#endif
    constexpr std::size_t size = 16384, count = 4096, kept = 64;  // 64 MiB, of which every 64th block is kept
    std::vector<std::unique_ptr<char[]>> blocks(count);
    double before = 0.0, after = 0.0;
    std::thread([&] {
        for (auto& block : blocks) {
            block = std::make_unique<char[]>(size);
            for (std::size_t i = 0; i < size; i += 1024) block[i] = 1;
        }
        for (std::size_t i = 0; i < count; ++i)
            if (i % kept != 0) blocks[i].reset();
        before = residentBytes();
        returnFreeMemory();
        after = residentBytes();
    }).join();
    EXPECT_GT(before - after, 0.8 * static_cast<double>(size * count));
}

}  // namespace
}  // namespace keyblock
