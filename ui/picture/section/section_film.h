// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Consecutive sections of a run for an animation. Settings that would change from one
// frame to the next are fixed for all of them beforehand: the window, the colour
// ranges, the bolt with the force diagram and the scale of the diagram, and the numbers
// of the events.
#pragma once

#include "ui/picture/section/section.h"

#include <cstddef>
#include <vector>

namespace keyblock {

class SectionFilm {
public:
    /// Prepares one section for each of `frames`, in this order. Reads all frames of the run.
    /// \param frames indices of frames of the run. \pre `frames` is not empty.
    SectionFilm(const RunSource& run, const SectionRequest& request, std::vector<std::size_t> frames);

    std::size_t size() const { return frames_.size(); }
    /// Index, among all frames of the run, of the frame that section number `picture` shows (counted from 0).
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
    std::optional<int> ribbon_;  // bolt with the largest value in any of the frames
    double largest_ = 0.0;  // largest magnitude of that bolt, in the display unit
    EventList numbered_;  // events numbered in the last frame
};

}  // namespace keyblock
