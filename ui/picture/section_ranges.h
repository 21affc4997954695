// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Legends of a section, with ranges over all frames of the run.
#pragma once

#include "ui/picture/section.h"

namespace keyblock {

/// Legends that grow frame by frame, for a run in progress.
class SectionRanges {
public:
    /// For the quantities of the request. \param scene as solved.
    SectionRanges(const Scene& scene, const SectionRequest& request);

    void add(const Frame& frame);
    /// Number of frames whose values are kept.
    std::size_t frames() const { return frames_.size(); }
    /// Discards the values of every second frame; the others represent all, except for the largest and smallest.
    void dropEverySecond();

    /// \param scales of the quantities, except for ranges of a single frame
    SectionLegends legends(const ScaleChoices& scales = {}) const;

private:
    struct Values {
        std::vector<Weighed> blocks, bolts;  // in the unit shown
        std::vector<double> forces;
    };

    std::vector<Weighed> peaks(const Frame& frame) const;
    std::vector<Weighed> blockPeaks(const Frame& frame) const;

    const FrameQuantity<BlockState>* blockQuantity_;
    const FrameQuantity<BoltNodeFrame>* boltQuantity_;
    bool contacts_;
    ContactScale scale_;
    double roundOff_ = 0.0;  // of the quantity of blocks
    std::vector<std::pair<double, std::string>> limits_;  // of the bolts
    std::optional<ValueRange> blockReach_, boltReach_;  // of all frames added
    std::vector<Values> frames_;
};

/// Legends for the request, over all frames of the run.
SectionLegends sectionLegends(const RunSource& run, const SectionRequest& request);

/// The same with a note on the values of one frame, if it has any, and with the ranges chosen in the request.
SectionLegends withNow(SectionLegends legends, const SectionRequest& request, const Frame& frame);

/// Limits of the bolt's steel for the quantity [unit shown]; none for quantities other than N.
std::vector<std::pair<double, std::string>> limitsOf(const Scene& scene, const Bolt& bolt,
                                                     const FrameQuantity<BoltNodeFrame>& quantity);

}  // namespace keyblock
