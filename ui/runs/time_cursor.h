// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which moment of which run is shown: one for section, time line, strip and curves.
// It plays, steps, jumps to events and follows a run that goes on.
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

/// A moment within a stage.
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

    /// Shows another run, its newest moment; null: none. `goesOn`: it still grows, and is followed.
    void setRun(std::shared_ptr<LiveRun> run, bool goesOn);
    /// The run grew. Moves on where it is followed.
    void grown();
    /// The run ended; what is shown is its last frame where it was followed.
    void ranOut();

    const std::shared_ptr<LiveRun>& run() const { return run_; }
    bool goesOn() const { return goesOn_; }
    /// Follows the newest moment of a run that goes on.
    bool isLive() const { return live_; }
    bool hasMoment() const;
    /// Stored frame that is shown; none: there is none yet, or it lies between the stored ones.
    std::optional<std::size_t> frame() const;
    /// The same, or the last one before; none: nothing is stored yet.
    std::optional<std::size_t> storedFrame() const;
    /// \pre there is a moment.
    FrameHead head() const;
    /// The moment for pictures, on any thread; null without one.
    std::shared_ptr<const Moment> moment() const;

    void goTo(std::size_t frame);
    void goTo(const StageTime& time);  // to the last frame that is not later
    void goToEvent(const Event& event);  // to the first frame that shows it; else the last
    void goLive();
    void step(int by);
    void home();
    void end();  // of a run that goes on: follows it
    /// To the state just before the next event of the kinds that are shown, where it was kept, then to the first frame
    /// that shows the event; false when there is none. Minor events are skipped where others are shown.
    bool nextEvent();
    bool previousEvent();  // to the last such frame before the one shown
    bool hasNextEvent() const { return nextEventFrame().has_value(); }
    bool hasPreviousEvent() const { return previousEventFrame().has_value(); }
    bool canStep(int by) const;  // to a frame that is there
    bool canGoHome() const;
    bool canGoToEnd() const;

    void playOrPause();  // of a run that is followed: stays at its last stored frame
    void play();
    void pause();
    bool isPlaying() const { return timer_.isActive(); }
    double speed() const { return speed_; }
    void setSpeed(double speed);  // 1: 25 frames a second
    bool loops() const { return loops_; }
    void setLoops(bool loops);

    /// The moment that others are compared with, a stored frame; none: not set. A is the moment itself.
    std::optional<std::size_t> cursorB() const { return b_; }
    void setCursorB(std::optional<std::size_t> frame);

    const std::set<std::size_t>& bookmarks() const { return bookmarks_; }
    void toggleBookmark();  // at the frame shown, or the last one before
    void toggleCursorB();

    /// Kinds of events that are hidden on the time line and passed over.
    const std::set<EventKind>& hiddenKinds() const { return hidden_; }
    void setHidden(EventKind kind, bool hidden);

Q_SIGNALS:
    void runChanged();
    void runGrew();
    void moved();  // to another moment
    void changed();  // playing, speed, loop, cursor B, bookmarks, kinds

private:
    /// How far the run was when it grew last.
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
