// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run and time shown, common to section, timeline, bolt diagram and curves. It
// plays, steps, jumps to events and follows a run in progress.
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

/// A time within a stage.
struct StageTime {
    int stage = 0;
    double time = 0.0;  // [s], or pseudo-time 0 … 1

    auto operator<=>(const StageTime&) const = default;
};

class TimeCursor : public QObject {
    Q_OBJECT

public:
    explicit TimeCursor(QObject* parent = nullptr);
    ~TimeCursor() override;

    /// Shows another run at its newest time; null: none. `goesOn`: it is in progress, and is followed.
    void setRun(std::shared_ptr<LiveRun> run, bool goesOn);
    /// The run grew. Moves to the end if it is followed.
    void grown();
    /// The run ended; its last frame is shown if it was followed.
    void ranOut();

    const std::shared_ptr<LiveRun>& run() const { return run_; }
    bool goesOn() const { return goesOn_; }
    /// Whether the newest time of a run in progress is followed.
    bool isLive() const { return live_; }
    bool hasMoment() const;
    /// Stored frame shown; none: there is none yet, or the time is between stored frames.
    std::optional<std::size_t> frame() const;
    /// The same, or the last one before; none: no frame is stored yet.
    std::optional<std::size_t> storedFrame() const;
    /// \pre `hasMoment()`.
    FrameHead head() const;
    /// Snapshot for pictures, on any thread; null without one.
    std::shared_ptr<const Moment> moment() const;

    void goTo(std::size_t frame);
    void goTo(const StageTime& time);  // to the last frame that is not later
    void goToEvent(const Event& event);  // to the first frame that shows it; else the last
    void goLive();
    void step(int by);
    void home();
    void end();  // of a run in progress: follows it
    /// To the state just before the next event of the visible kinds, if it was kept, then to the first frame that
    /// shows the event; false if there is none. Minor events are skipped if others are shown.
    bool nextEvent();
    bool previousEvent();  // to the last such frame before the one shown
    bool hasNextEvent() const { return nextEventFrame().has_value(); }
    bool hasPreviousEvent() const { return previousEventFrame().has_value(); }
    bool canStep(int by) const;  // to an existing frame
    bool canGoHome() const;
    bool canGoToEnd() const;

    void playOrPause();  // of a run that is followed: stops at its last stored frame
    void play();
    void pause();
    bool isPlaying() const { return timer_.isActive(); }
    double speed() const { return speed_; }
    void setSpeed(double speed);  // 1: 25 frames a second
    bool loops() const { return loops_; }
    void setLoops(bool loops);

    /// The time that others are compared with, a stored frame; none: not set. A is the time shown.
    std::optional<std::size_t> cursorB() const { return b_; }
    void setCursorB(std::optional<std::size_t> frame);

    const std::set<std::size_t>& bookmarks() const { return bookmarks_; }
    void toggleBookmark();  // at the frame shown, or the last one before
    void toggleCursorB();

    /// Kinds of events that are hidden on the timeline and skipped.
    const std::set<EventKind>& hiddenKinds() const { return hidden_; }
    void setHidden(EventKind kind, bool hidden);

Q_SIGNALS:
    void runChanged();
    void runGrew();
    void moved();  // to another time
    void changed();  // playing, speed, loop, cursor B, bookmarks, kinds

private:
    /// Size of the run when it last grew.
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
