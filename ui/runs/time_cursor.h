// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run and the time shown, common to section, timeline, bolt diagram and curves.
// Plays the run, steps through its frames, jumps to events, and follows a run in
// progress.
#pragma once

#include "solver/results/run_source.h"

#include <QObject>
#include <QTimer>

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace keyblock {

class LiveRun;
class Moment;

/// A time, counted from the start of its stage.
struct StageTime {
    int stage = 0;
    double time = 0.0;  // [s], or pseudo-time 0 … 1 in a static stage

    auto operator<=>(const StageTime&) const = default;
};

class TimeCursor : public QObject {
    Q_OBJECT

public:
    explicit TimeCursor(QObject* parent = nullptr);
    ~TimeCursor() override;

    /// Shows another run at its latest time; null: no run.
    /// \param goesOn true if the run is in progress. The cursor then follows the run, i.e. stays at its latest time.
    void setRun(std::shared_ptr<LiveRun> run, bool goesOn);
    /// Call this when the run has new results. Moves to the latest time if the cursor follows the run.
    void grown();
    /// Call this when the run has ended. Moves to the last frame if the cursor was following the run.
    void ranOut();

    const std::shared_ptr<LiveRun>& run() const { return run_; }
    bool goesOn() const { return goesOn_; }
    /// True while the cursor follows a run in progress.
    bool isLive() const { return live_; }
    bool hasMoment() const;
    /// Index of the stored frame that is shown; none if no frame is stored yet or the state shown is not stored.
    std::optional<std::size_t> frame() const;
    /// Like `frame`, but if the state shown is not stored, the index of the last stored frame. None only if no frame is
    /// stored yet.
    std::optional<std::size_t> storedFrame() const;
    /// Head of the state shown. \pre `hasMoment()` is true.
    FrameHead head() const;
    /// Snapshot of the state shown, from which any thread can make drawings; null if `hasMoment()` is false.
    std::shared_ptr<const Moment> moment() const;

    void goTo(std::size_t frame);
    void goTo(const StageTime& time);  // shows the last frame that is not later
    void goToEvent(const Event& event);  // shows the first frame that includes the event; otherwise the last frame
    void goLive();
    void step(int by);
    void home();
    void end();  // shows the last frame; if a run is in progress, follows it
    /// Moves to the stored frame with the state just before the next event. If there is no such frame or it is already
    /// shown, moves to the first frame that includes the event. Hidden kinds of events are skipped. Minor events are
    /// skipped unless there are no others. Returns false if there is no further event.
    bool nextEvent();
    bool previousEvent();  // moves to the last such frame before the one shown
    bool hasNextEvent() const { return nextEventFrame().has_value(); }
    bool hasPreviousEvent() const { return previousEventFrame().has_value(); }
    bool canStep(int by) const;  // whether the frame exists
    bool canGoHome() const;
    bool canGoToEnd() const;

    void playOrPause();  // while a run is followed: stops at its last stored frame
    void play();
    void pause();
    bool isPlaying() const { return timer_.isActive(); }
    double speed() const { return speed_; }
    void setSpeed(double speed);  // 1: 25 frames per second
    bool loops() const { return loops_; }
    void setLoops(bool loops);

    /// Index of the stored frame at cursor B, which is compared with the time shown (cursor A); none if cursor B is not
    /// set.
    std::optional<std::size_t> cursorB() const { return b_; }
    void setCursorB(std::optional<std::size_t> frame);

    const std::set<std::size_t>& bookmarks() const { return bookmarks_; }
    void toggleBookmark();  // at the frame shown, or at the last stored frame before it
    void toggleCursorB();

    /// Kinds of events that the timeline hides and that jumps to events skip.
    const std::set<EventKind>& hiddenKinds() const { return hidden_; }
    void setHidden(EventKind kind, bool hidden);

Q_SIGNALS:
    void runChanged();
    void runGrew();
    void moved();  // another time is shown
    void changed();  // playback, speed, loop, cursor B, bookmarks or hidden kinds

private:
    /// State of the run at the last call of `grown`.
    struct Followed {
        int stage = -1;
        long step = -1;
        double time = 0.0;
        std::size_t frames = 0;

        bool operator==(const Followed&) const = default;
    };

    void show(std::size_t frame);
    void advance();
    long stepFrom(int by) const;
    bool passesMinor() const;
    bool stopsAt(const Event& event, bool passesMinor) const;
    std::optional<std::size_t> nextEventFrame() const;
    std::optional<std::size_t> previousEventFrame() const;
    std::optional<std::size_t> frameAt(const StageTime& time) const;
    std::optional<std::size_t> frameAfter(long event) const;
    std::optional<std::size_t> frameBefore(long event) const;

    std::shared_ptr<LiveRun> run_;
    bool goesOn_ = false, live_ = false, loops_ = false;
    std::size_t frame_ = 0;
    Followed followed_;
    double speed_ = 1.0;
    std::optional<std::size_t> b_;
    std::set<std::size_t> bookmarks_;
    std::set<EventKind> hidden_;
    QTimer timer_;
};

}  // namespace keyblock
