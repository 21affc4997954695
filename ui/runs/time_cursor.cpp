// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/time_cursor.h"

#include "solver/scene/event_kinds.h"
#include "ui/runs/live_run.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace keyblock {

namespace {

constexpr double framesPerSecond = 25.0;
constexpr int shortestInterval = 33;  // [ms] between frames; faster playback skips frames

StageTime timeOf(const FrameHead& head) { return {head.stage, head.time}; }
StageTime timeOf(const Event& event) { return {event.stage, event.time}; }

}  // namespace

TimeCursor::TimeCursor(QObject* parent) : QObject(parent) {
    connect(&timer_, &QTimer::timeout, this, &TimeCursor::advance);
}

TimeCursor::~TimeCursor() = default;

void TimeCursor::setRun(std::shared_ptr<LiveRun> run, bool goesOn) {
    timer_.stop();
    run_ = std::move(run);
    goesOn_ = run_ && goesOn;
    live_ = goesOn_;
    followed_ = {};
    frame_ = run_ && !run_->frames().empty() ? run_->frames().size() - 1 : 0;
    b_ = std::nullopt;
    bookmarks_.clear();
    Q_EMIT runChanged();
    Q_EMIT changed();
    Q_EMIT moved();
}

void TimeCursor::grown() {
    if (!run_) return;
    const bool first = !live_ && run_->frames().size() == 1;
    if (live_ && !run_->frames().empty()) frame_ = run_->frames().size() - 1;
    Q_EMIT runGrew();
    // A progress report alone shows nothing new, nor does a paused run that is read again.
    const ShownFrame& newest = run_->newest();
    const Followed now{newest.frame ? newest.frame->stage : -1, newest.frame ? newest.frame->step : -1,
                       newest.frame ? newest.frame->time : 0.0, run_->frames().size()};
    const bool isNew = !(now == followed_);
    followed_ = now;
    if ((live_ && isNew) || first) Q_EMIT moved();
}

void TimeCursor::ranOut() {
    goesOn_ = false;
    const bool followed = std::exchange(live_, false);
    if (followed && run_ && !run_->frames().empty()) frame_ = run_->frames().size() - 1;
    Q_EMIT changed();
    Q_EMIT moved();
}

bool TimeCursor::hasMoment() const {
    return run_ && (!run_->frames().empty() || (live_ && run_->newest().frame));
}

std::optional<std::size_t> TimeCursor::frame() const {
    if (!hasMoment()) return std::nullopt;
    if (live_ && run_->newest().frame) return run_->newest().stored;
    return frame_;
}

std::optional<std::size_t> TimeCursor::storedFrame() const {
    return run_ && !run_->frames().empty() ? std::optional(frame_) : std::nullopt;
}

FrameHead TimeCursor::head() const {
    assert(hasMoment());
    if (live_ && run_->newest().frame) {
        const Frame& newest = *run_->newest().frame;
        return {newest.stage, newest.time, newest.step, newest.energy};
    }
    return run_->frames()[frame_];
}

std::shared_ptr<const Moment> TimeCursor::moment() const {
    if (!hasMoment()) return nullptr;
    if (live_ && run_->newest().frame) return std::make_shared<const Moment>(run_);
    return std::make_shared<const Moment>(run_, frame_);
}

void TimeCursor::show(std::size_t frame) {
    if (!live_ && frame == frame_) return;
    const bool wasLive = std::exchange(live_, false);
    frame_ = frame;
    if (wasLive) Q_EMIT changed();
    Q_EMIT moved();
}

void TimeCursor::goTo(std::size_t frame) {
    if (!run_ || run_->frames().empty()) return;
    show(std::min(frame, run_->frames().size() - 1));
}

void TimeCursor::goTo(const StageTime& time) {
    if (!run_ || run_->frames().empty()) return;
    show(frameAt(time).value_or(0));
}

void TimeCursor::goToEvent(const Event& event) {
    if (!run_ || run_->frames().empty()) return;
    const auto& events = run_->eventList();
    const auto found = std::find(events.begin(), events.end(), event);
    const auto shown = found == events.end() ? std::nullopt : frameAfter(found - events.begin());
    show(shown.value_or(run_->frames().size() - 1));
}

void TimeCursor::goLive() {
    if (!goesOn_ || live_) return;
    pause();
    live_ = true;
    if (!run_->frames().empty()) frame_ = run_->frames().size() - 1;
    Q_EMIT changed();
    Q_EMIT moved();
}

/// Index of the frame that a step leads to. From a live state after the last stored frame, one step back leads to that
/// frame.
long TimeCursor::stepFrom(int by) const {
    const bool between = live_ && !frame();
    return static_cast<long>(frame_) + by + (between && by < 0 ? 1 : 0);
}

void TimeCursor::step(int by) {
    if (!run_ || run_->frames().empty()) return;
    pause();
    const auto last = static_cast<long>(run_->frames().size()) - 1;
    if (live_ && stepFrom(by) > last) return;
    show(static_cast<std::size_t>(std::clamp(stepFrom(by), 0L, last)));
}

bool TimeCursor::canStep(int by) const {
    if (!run_ || run_->frames().empty()) return false;
    const long to = stepFrom(by);
    return to < static_cast<long>(run_->frames().size()) && (to >= 0 || live_);
}

bool TimeCursor::canGoHome() const { return run_ && !run_->frames().empty() && (live_ || frame_ > 0); }

bool TimeCursor::canGoToEnd() const {
    if (goesOn_) return !live_;
    return run_ && frame_ + 1 < run_->frames().size();
}

void TimeCursor::home() {
    if (!run_ || run_->frames().empty()) return;
    show(0);
}

void TimeCursor::end() {
    if (goesOn_) return goLive();
    if (run_ && !run_->frames().empty()) show(run_->frames().size() - 1);
}

/// The last frame that is not later than `time`.
std::optional<std::size_t> TimeCursor::frameAt(const StageTime& time) const {
    const auto& frames = run_->frames();
    const auto after = std::upper_bound(frames.begin(), frames.end(), time, [](const StageTime& t, const FrameHead& f) {
        return t < timeOf(f);
    });
    if (after == frames.begin()) return std::nullopt;
    return static_cast<std::size_t>(after - frames.begin()) - 1;
}

/// The first frame that already includes an event of the run.
std::optional<std::size_t> TimeCursor::frameAfter(long event) const {
    const auto& frames = run_->frames();
    const auto after = std::upper_bound(frames.begin(), frames.end(), event, [](long e, const FrameHead& f) {
        return e < f.events;
    });
    if (after == frames.end()) return std::nullopt;
    return after - frames.begin();
}

/// The frame with the state just before an event, if that state was stored.
std::optional<std::size_t> TimeCursor::frameBefore(long event) const {
    const std::size_t end = frameAfter(event).value_or(run_->frames().size());
    if (end == 0 || timeOf(run_->frames()[end - 1]) != timeOf(run_->eventList()[event]))
        return std::nullopt;
    return end - 1;
}

/// Whether there are events other than joint slips, which occur by the thousand.
bool TimeCursor::passesMinor() const {
    const auto& events = run_->eventList();
    return std::any_of(events.begin(), events.end(), [this](const Event& event) { return stopsAt(event, true); });
}

bool TimeCursor::stopsAt(const Event& event, bool passesMinor) const {
    return !hidden_.contains(event.kind) && !(passesMinor && isMinor(event.kind));
}

std::optional<std::size_t> TimeCursor::nextEventFrame() const {
    if (!hasMoment()) return std::nullopt;
    const bool passes = passesMinor();
    const auto& events = run_->eventList();
    for (auto i = head().events; i < static_cast<long>(events.size()); ++i) {
        if (!stopsAt(events[i], passes)) continue;
        const auto before = frameBefore(i);
        return before && *before > frame_ ? before : frameAfter(i);
    }
    return std::nullopt;
}

std::optional<std::size_t> TimeCursor::previousEventFrame() const {
    const std::size_t shown = hasMoment() ? frame().value_or(run_->frames().size()) : 0;
    if (shown == 0) return std::nullopt;
    const bool passes = passesMinor();
    const auto& events = run_->eventList();
    for (auto i = static_cast<long>(events.size()) - 1; i >= 0; --i) {
        if (!stopsAt(events[i], passes)) continue;
        for (const auto& stop : {frameAfter(i), frameBefore(i)})
            if (stop && *stop < shown) return stop;
    }
    return std::nullopt;
}

bool TimeCursor::nextEvent() {
    const auto frame = nextEventFrame();
    if (hasMoment()) pause();
    if (frame) show(*frame);
    return frame.has_value();
}

bool TimeCursor::previousEvent() {
    const auto frame = previousEventFrame();
    if (hasMoment()) pause();
    if (frame) show(*frame);
    return frame.has_value();
}

void TimeCursor::playOrPause() {
    if (isPlaying()) pause();
    else if (!live_) play();
    else if (storedFrame()) show(frame_);
}

void TimeCursor::play() {
    if (!run_ || run_->frames().size() < 2 || isPlaying() || live_) return;  // a live run advances by itself
    if (frame_ + 1 >= run_->frames().size()) show(0);
    timer_.start(std::max(shortestInterval, static_cast<int>(std::lround(1000.0 / (framesPerSecond * speed_)))));
    Q_EMIT changed();
}

void TimeCursor::pause() {
    if (!isPlaying()) return;
    timer_.stop();
    Q_EMIT changed();
}

void TimeCursor::advance() {
    const std::size_t count = run_ ? run_->frames().size() : 0;
    if (count == 0) return pause();
    const double wanted = 1e-3 * timer_.interval() * framesPerSecond * speed_;
    const auto by = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(wanted)));
    if (frame_ + 1 < count) return show(std::min(frame_ + by, count - 1));
    if (loops_) return show(0);
    pause();
    if (goesOn_) goLive();
}

void TimeCursor::setSpeed(double speed) {
    speed_ = std::clamp(speed, 0.05, 100.0);
    if (isPlaying()) {
        timer_.stop();
        play();
    }
    Q_EMIT changed();
}

void TimeCursor::setLoops(bool loops) {
    loops_ = loops;
    Q_EMIT changed();
}

void TimeCursor::setCursorB(std::optional<std::size_t> frame) {
    if (frame && (!run_ || *frame >= run_->frames().size())) frame = std::nullopt;
    b_ = frame;
    Q_EMIT changed();
}

void TimeCursor::toggleCursorB() { setCursorB(b_ == storedFrame() ? std::nullopt : storedFrame()); }

void TimeCursor::toggleBookmark() {
    const auto at = storedFrame();
    if (!at) return;
    if (!bookmarks_.erase(*at)) bookmarks_.insert(*at);
    Q_EMIT changed();
}

void TimeCursor::setHidden(EventKind kind, bool hidden) {
    if (hidden) hidden_.insert(kind);
    else hidden_.erase(kind);
    Q_EMIT changed();
}

}  // namespace keyblock
