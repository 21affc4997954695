// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Consecutive pictures of a run. Settings that would jump from one to the next are
// fixed for all of them first: the window, the ranges, the bolt of the force diagram
// and its scale, and the numbers of events.
#pragma once

#include "ui/picture/section.h"

#include <cstddef>
#include <vector>

namespace keyblock {

class SectionFilm {
public:
    /// Pictures of these frames of the run, in this order; at least one. Reads every frame of the run twice.
    SectionFilm(const RunSource& run, const SectionRequest& request, std::vector<std::size_t> frames);

    std::size_t size() const { return frames_.size(); }
    /// Index into the run's frames.
    std::size_t frame(std::size_t picture) const { return frames_[picture]; }
    SectionPicture picture(std::size_t index) const;

private:
    SectionPicture pictureOf(std::size_t frame, const std::optional<int>& ribbon, double ribbonScale,
                             const std::optional<Box>& window) const;
    void settle(const SectionPicture& picture);
    void keepNumbered(EventList& events) const;

    const RunSource& run_;
    SectionRequest request_;
    std::vector<std::size_t> frames_;
    SectionLegends legends_;
    std::optional<Box> window_;
    std::optional<int> ribbon_;  // bolt with the largest value of all frames
    double largest_ = 0.0;  // that value
    EventList numbered_;  // at the end of the animation
};

}  // namespace keyblock
