// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/section_feed.h"

#include "ui/look/display.h"
#include "ui/picture/charts/bolt_chart.h"
#include "ui/picture/section/section_ranges.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"
#include "ui/runs/view_settings.h"

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

constexpr std::size_t mostValues = 100000;  // block values kept for the ranges, in all frames together
constexpr std::size_t fewestFrames = 8, mostFrames = 64;  // limits of the number of frames whose values are kept
constexpr std::size_t mostRead = 600;  // frames read from a stored run, evenly spread

}  // namespace

/// Ranges and legends of a run. Used by one thread at a time.
struct SectionFeed::Ranges {
    std::shared_ptr<const LiveRun> run;
    const FrameQuantity<BlockState>* blocks;
    const FrameQuantity<BoltNodeFrame>* bolts;
    bool contacts;
    SectionRanges ranges;
    std::optional<std::pair<int, long>> newest;  // stage and step of the last frame added
    std::optional<SectionLegends> legends;
    ScaleChoices scales;  // of these legends
    int held = -1;  // index of the most loaded bolt of the run so far

    /// \param scene its bolt types give the steel limits
    Ranges(std::shared_ptr<const LiveRun> of, const Scene& scene, const SectionRequest& request)
        : run(std::move(of)), blocks(request.blocks), bolts(request.bolts), contacts(request.contacts),
          ranges(scene, request) {}

    bool fits(const std::shared_ptr<LiveRun>& other, const SectionRequest& request) const {
        return run == other && blocks == request.blocks && bolts == request.bolts && contacts == request.contacts;
    }

    void add(const Frame& frame) {
        const std::pair at{frame.stage, frame.step};
        if (newest && at <= *newest) return;
        newest = at;
        held = mostLoadedBolt(frame, held);
        widen(frame);
    }

    void widen(const Frame& frame) {
        ranges.add(frame);
        const std::size_t most = std::clamp(mostValues / std::max<std::size_t>(1, frame.blocks.size()), fewestFrames,
                                            mostFrames);
        if (ranges.frames() > most) ranges.dropEverySecond();
        legends.reset();
    }

    /// Adds all frames of a store, or an evenly spread subset. Stops if the job is superseded.
    void addStored(const LiveRun& of, std::size_t count, const Background& job) {
        const std::size_t read = std::min(count, mostRead);
        for (std::size_t i = 0; i < read && !job.isOvertaken(); ++i) {
            const Frame frame = of.frame(read == 1 ? 0 : i * (count - 1) / (read - 1));
            &of == run.get() ? add(frame) : widen(frame);
            if (&of == run.get() && i + 1 == read) held = mostLoadedBolt(frame);  // its peaks are of the whole run
        }
    }

    const SectionLegends& current(const ScaleChoices& wanted) {
        if (!legends || scales != wanted) legends = ranges.legends(wanted);
        scales = wanted;
        return *legends;
    }
};

SectionFeed::SectionFeed(const BoltChoice& choice, TimeCursor& cursor, ViewSettings& settings, const Display& display,
                         QObject* parent)
    : QObject(parent), choice_(choice), cursor_(cursor), settings_(settings), display_(display) {
    connect(&display, &Display::changed, this, &SectionFeed::make);
    connect(&cursor, &TimeCursor::runChanged, this, &SectionFeed::runChanged);
    connect(&cursor, &TimeCursor::moved, this, &SectionFeed::make);
    connect(&settings, &ViewSettings::changed, this, &SectionFeed::make);
    connect(&cursor, &TimeCursor::changed, this, [this] {
        if (std::exchange(goesOn_, cursor_.goesOn()) && !cursor_.goesOn()) runEnded();
    });
    connect(&choice, &BoltChoice::changed, this, [this] {
        if (settings_.choice().ribbon == RibbonOf::Selected) make();
    });
    make();
}

SectionFeed::~SectionFeed() = default;

void SectionFeed::showResults(bool results) {
    results_ = results;
    make();
}

bool SectionFeed::showsResults() const { return results_ && cursor_.hasMoment(); }

/// Shows the results of the newly chosen run.
void SectionFeed::runChanged() {
    if (cursor_.run()) results_ = true;
    goesOn_ = cursor_.goesOn();
    other_.reset();
    ranges_.reset();
    picture_.reset();
    frame_.reset();
    make();
}

/// Gathers the ranges of all stored frames; during the run, ranges covered only the frames that were shown.
void SectionFeed::runEnded() {
    if (ranges_ && showsResults()) gatherRanges();
    else ranges_.reset();
}

SectionRequest SectionFeed::request() const {
    const ViewChoice& choice = settings_.choice();
    SectionRequest request;
    request.frame = 0;
    request.activity = choice.activity;
    request.blocks = choice.activity ? nullptr : choice.blocks;
    request.bolts = choice.bolts;
    request.arrows = choice.arrows;
    request.contacts = choice.contacts;
    request.everyContact = true;
    request.factor = choice.factor;
    request.scales = choice.scales;
    if (other_)  // scales of single frames would differ between the runs
        for (auto& [quantity, scale] : request.scales)
            if (scale.of == ScaleOf::ThisFrame) scale.of = ScaleOf::AllFrames;
    if (!choice.callOuts) request.mostEvents = 0;
    const int bolt = choice_.bolt();
    if (choice.ribbon == RibbonOf::Selected && bolt >= 0) request.ribbon = bolt;
    return request;
}

void SectionFeed::make() {
    if (showsResults() != showed_) {
        showed_ = !showed_;
        Q_EMIT modeChanged();
    }
    if (!showsResults()) return;
    const SectionRequest wanted = request();
    if (!ranges_ || !ranges_->fits(cursor_.run(), wanted)) {
        const int held = ranges_ && ranges_->run == cursor_.run() ? ranges_->held : -1;
        ranges_ = emptyRanges();
        ranges_->held = held;
        gatherRanges();
    }
    painting_.ask([this, wanted, moment = cursor_.moment(), ranges = ranges_,
                   numbers = display_.numbers(), ribbon = settings_.choice().ribbon]() -> Background::Result {
        try {
            SectionRequest full = wanted;
            const std::shared_ptr<const Frame> frame = moment->sharedFrame();
            ranges->add(*frame);
            const SectionLegends& legends = ranges->current(wanted.scales);
            full.legends = &legends;
            if (legends.bolts) full.ribbonScale = legends.bolts->reach.high;
            if (!full.ribbon && ranges->held >= 0) full.ribbon = ranges->held;
            auto picture = std::make_shared<SectionPicture>(sectionPicture(*moment, full));
            if (ribbon == RibbonOf::Nothing) picture->ribbon.reset();
            showAs(*picture, numbers);
            return [this, picture, frame, run = ranges->run] {
                if (showsResults() && cursor_.run() == run) put(picture, frame);
            };
        } catch (const std::exception& error) {
            return [this, text = QString::fromStdString(error.what())] { Q_EMIT failed(text); };
        }
    });
}

std::shared_ptr<SectionFeed::Ranges> SectionFeed::emptyRanges() const {
    const Scene& scene = other_ && !leads_ ? other_->scene() : cursor_.run()->scene();
    return std::make_shared<Ranges>(cursor_.run(), scene, request());
}

void SectionFeed::shareRanges(std::shared_ptr<const LiveRun> other, bool leads) {
    other_ = std::move(other);
    leads_ = leads;
    ranges_.reset();
    make();
}

/// Reads the values of stored frames while painting continues. Two runs that share their ranges are read in the same
/// order by both feeds, so that both get the same ranges.
void SectionFeed::gatherRanges() {
    const std::size_t count = cursor_.run()->frames().size(), others = other_ ? other_->frames().size() : 0;
    if (count + others < 2) return;
    gathering_.ask([this, ranges = emptyRanges(), count, other = other_, others, leads = leads_]() -> Background::Result {
        try {
            if (other && !leads) ranges->addStored(*other, others, gathering_);
            ranges->addStored(*ranges->run, count, gathering_);
            if (other && leads) ranges->addStored(*other, others, gathering_);
        } catch (const std::exception&) {
            // Painting reports a store that cannot be read; the ranges use the frames that were readable.
        }
        return [this, ranges, other] {
            if (other == other_) takeRanges(ranges);
        };
    });
}

void SectionFeed::takeRanges(std::shared_ptr<Ranges> ranges) {
    if (!ranges_ || !cursor_.run() || !ranges->fits(cursor_.run(), request())) return;
    ranges_ = std::move(ranges);
    make();
}

void SectionFeed::put(std::shared_ptr<const SectionPicture> picture, std::shared_ptr<const Frame> frame) {
    if (picture == picture_) return;
    picture_ = std::move(picture);
    frame_ = std::move(frame);
    Q_EMIT pictureChanged();
}

}  // namespace keyblock
