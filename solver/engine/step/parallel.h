// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parallel loops. Debian's oneTBB is not built for the thread sanitizer, which
// therefore does not see that a loop starts after the code before it and finishes
// before the code after it. The annotations here inform it of both, so that it reports
// only genuine races.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace keyblock {

/// Calls body(i) in parallel for every i below `count`.
/// \param grain the grain size: ranges of at most this many indices are not split further.
/// \pre no two calls write to the same location.
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

/// Calls body(i) for every i below `count`, in parallel only if there are at least two grains.
template <typename Body>
void forEach(std::size_t count, std::size_t grain, const Body& body) {
    if (count >= 2 * grain) return inParallel(count, grain, body);
    for (std::size_t i = 0; i < count; ++i) body(i);
}

}  // namespace keyblock
