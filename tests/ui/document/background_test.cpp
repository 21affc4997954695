// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Jobs in the background: which of them run, and in what order their results arrive.
#include "tests/ui/screen/screen.h"

#include "ui/document/background.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace keyblock {
namespace {

/// A thread whose first job runs until `mayEnd`, so that later requests wait.
struct BusyBackground {
    std::vector<int> results;
    std::atomic<bool> started{false}, mayEnd{false};
    std::atomic<bool> wasOvertaken{false};
    Background thread;

    BusyBackground() {
        thread.ask([this]() -> Background::Result {
            started = true;
            while (!mayEnd) std::this_thread::yield();
            wasOvertaken = thread.isOvertaken();
            return [this] { results.push_back(0); };
        });
        while (!started) std::this_thread::yield();
    }
    ~BusyBackground() { mayEnd = true; }

    std::function<Background::Result()> job(int number) {
        return [this, number]() -> Background::Result { return [this, number] { results.push_back(number); }; };
    }
};

TEST(Background, NewestRequestReplacesWaitingOnes) {
    NEED_SCREEN();
    BusyBackground busy;
    busy.thread.ask(busy.job(1));
    busy.thread.ask(busy.job(2));
    busy.mayEnd = true;
    ASSERT_TRUE(waitFor([&] { return busy.results.size() == 2; }));
    EXPECT_EQ(busy.results, (std::vector<int>{0, 2}));
    EXPECT_TRUE(busy.wasOvertaken);
}

TEST(Background, AddedJobsRunInOrderAndOvertakeNone) {
    NEED_SCREEN();
    BusyBackground busy;
    for (int number = 1; number < 4; ++number) busy.thread.add(busy.job(number));
    busy.mayEnd = true;
    ASSERT_TRUE(waitFor([&] { return busy.results.size() == 4; }));
    EXPECT_EQ(busy.results, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_FALSE(busy.wasOvertaken);
}

}  // namespace
}  // namespace keyblock
