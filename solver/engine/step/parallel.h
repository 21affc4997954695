// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops on all threads. Debian's oneTBB is not built for the thread sanitizer, which
// therefore misses that the loop begins after what was before it and ends before what
// comes after; here it is informed of both, so that it finds our own races.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace keyblock {

/// body(i) for every i below `count`, in tasks of `grain` or more. Each writes to places of its own.
template <typename Body>
void inParallel(std::size_t count, std::size_t grain, const Body& body) {
#ifdef __SANITIZE_THREAD__
    char begun = 0, ended = 0;
    __tsan_release(&begun);
#endif
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
#ifdef __SANITIZE_THREAD__
        __tsan_acquire(&begun);
#endif
        for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
#ifdef __SANITIZE_THREAD__
        __tsan_release(&ended);
#endif
    });
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(&ended);
#endif
}

}  // namespace keyblock
