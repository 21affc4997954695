// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/section_film.h"

#include "ui/picture/section/section_ranges.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {

namespace {

bool isSame(const EventEntry& a, const EventEntry& b) {
    return a.kind == b.kind && a.stage == b.stage && a.bolt == b.bolt && a.time == b.time &&
           (a.bolt >= 0 || a.block == b.block);
}

}  // namespace

SectionFilm::SectionFilm(const RunSource& run, const SectionRequest& request, std::vector<std::size_t> frames)
    : run_(run), request_(request), frames_(std::move(frames)), legends_(sectionLegends(run, request)) {
    assert(!frames_.empty());
    numbered_ = eventList(run, eventsUntil(run.events(), run.frames()[frames_.back()]), request.mostEvents);
    request_.mostEvents = std::numeric_limits<std::size_t>::max();
    for (const std::size_t frame : frames_) settle(pictureOf(frame, request.ribbon, 0.0, request.window));
}

SectionPicture SectionFilm::pictureOf(std::size_t frame, const std::optional<int>& ribbon,
                                      double ribbonScale, const std::optional<Box>& window) const {
    SectionRequest request = request_;
    request.legends = &legends_;
    request.frame = frame;
    request.ribbon = ribbon;
    request.ribbonScale = ribbonScale;
    request.window = window;
    return sectionPicture(run_, request);
}

/// Extends the shared window and the shared scale of the force diagram to include this picture.
void SectionFilm::settle(const SectionPicture& picture) {
    if (!window_) window_ = picture.window;
    window_ = Box{window_->min.cwiseMin(picture.window.min), window_->max.cwiseMax(picture.window.max)};
    if (!picture.ribbon) return;
    const BoltShape& bolt = picture.bolts[picture.ribbon->shape];
    const double largest = std::abs(bolt.values[picture.ribbon->peak]);
    if (largest <= largest_) return;
    largest_ = largest;
    ribbon_ = bolt.bolt;
}

/// Events get the numbers of the final list; events that are not in that list are omitted here, too.
void SectionFilm::keepNumbered(EventList& events) const {
    std::vector<EventEntry> kept;
    for (EventEntry& entry : events.entries)
        for (const EventEntry& last : numbered_.entries)
            if (isSame(entry, last)) {
                entry.number = last.number;
                kept.push_back(std::move(entry));
                break;
            }
    events.leftOut = static_cast<int>(events.entries.size() - kept.size());
    events.entries = std::move(kept);
}

SectionPicture SectionFilm::picture(std::size_t index) const {
    SectionPicture picture = pictureOf(frames_[index], ribbon_, largest_, window_);
    keepNumbered(picture.events);
    return picture;
}

}  // namespace keyblock
