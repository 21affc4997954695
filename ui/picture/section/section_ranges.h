// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Legends of a section, with ranges that cover all frames of the run.
#pragma once

#include "ui/picture/section/section.h"

namespace keyblock {

/// Legends that are updated frame by frame while a run is in progress.
class SectionRanges {
public:
    /// Creates empty legends for the quantities in `request`. \param scene the scene as solved, i.e. cut into blocks.
    SectionRanges(const Scene& scene, const SectionRequest& request);

    void add(const Frame& frame);
    /// Number of frames whose values are stored.
    std::size_t frames() const { return frames_.size(); }
    /// Discards the stored values of every second frame to save memory. The legends still cover the largest and
    /// smallest values of all frames.
    void dropEverySecond();

    /// Legends for all frames added so far.
    /// \param scales the user's choices of colour ranges. Only the choice to exclude extreme values is applied here; a
    /// range of a single frame and a range typed by the user are applied by `withNow`.
    SectionLegends legends(const ScaleChoices& scales = {}) const;

private:
    struct Values {
        std::vector<Weighed> blocks, bolts;  // in the display unit
        std::vector<double> forces;
    };

    std::vector<Weighed> peaks(const Frame& frame) const;
    std::vector<Weighed> blockPeaks(const Frame& frame) const;

    const FrameQuantity<BlockState>* blockQuantity_;
    const FrameQuantity<BoltNodeFrame>* boltQuantity_;
    bool contacts_;
    ContactScale scale_;
    double roundOff_ = 0.0;  // block values up to this magnitude are treated as zero
    std::vector<std::pair<double, std::string>> limits_;  // capacities of the bolts
    std::optional<ValueRange> blockReach_, boltReach_;  // ranges over all frames added
    std::vector<Values> frames_;
};

/// Legends for a request; reads all frames of the run.
SectionLegends sectionLegends(const RunSource& run, const SectionRequest& request);

/// The legends completed for one frame. The colour ranges that the user has chosen (`request.scales`) are applied. If
/// the frame has values, a note with their range is added.
SectionLegends withNow(SectionLegends legends, const SectionRequest& request, const Frame& frame);

/// Yield force and ultimate force of a bolt's steel, in the display unit of the quantity, each with its name. Empty if
/// the quantity is not the axial force.
std::vector<std::pair<double, std::string>> limitsOf(const Scene& scene, const Bolt& bolt,
                                                     const FrameQuantity<BoltNodeFrame>& quantity);

}  // namespace keyblock
