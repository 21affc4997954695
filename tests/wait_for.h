// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Waits for another thread or program. The limit only ends a broken test; tests of the
// window use `keyblock::waitFor`, which also handles events.
#pragma once

#include <chrono>
#include <thread>

namespace keyblock::test {

/// Waits until `done()` is true; false if it is not within the limit.
template <typename Done>
bool waitFor(Done done, std::chrono::seconds limit = std::chrono::seconds(120)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!done()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

}  // namespace keyblock::test
