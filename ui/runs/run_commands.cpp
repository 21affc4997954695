// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_commands.h"

#include "ui/look/commands.h"
#include "ui/runs/live_run.h"
#include "ui/runs/run_session.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"

namespace keyblock {

namespace {

/// Commands are enabled only when they have an effect.
void enableRunCommands(Commands& commands, const Runs& runs) {
    using State = RunSession::State;
    const State state = runs.isRunning() ? runs.session()->state() : State::Ended;
    const bool goesOn = state == State::Running || state == State::Paused;
    commands.setWhyNot("run.start", state == State::Ended ? runs.nothingToRun() : Runs::tr("A run is already in progress."));
    commands.action("run.pause")->setEnabled(goesOn);
    commands.action("run.pause")->setText(state == State::Paused ? Runs::tr("Continue run") : Runs::tr("Pause run"));
    commands.action("run.step")->setEnabled(goesOn);
    commands.action("run.stop")->setEnabled(goesOn || state == State::Preparing);
}

void enableTimeCommands(Commands& commands, const TimeCursor& cursor) {
    const std::size_t frames = cursor.run() ? cursor.run()->frames().size() : 0;
    const auto enable = [&](const char* id, bool on) { commands.action(id)->setEnabled(on); };
    for (const char* id : {"time.bookmark", "time.compare"}) enable(id, frames > 0);
    enable("time.play", frames > 1 || (frames == 1 && cursor.isLive()));
    enable("time.next", cursor.canStep(1));
    enable("time.previous", cursor.canStep(-1));
    enable("time.home", cursor.canGoHome());
    enable("time.end", cursor.canGoToEnd());
    enable("time.nextEvent", cursor.hasNextEvent());
    enable("time.previousEvent", cursor.hasPreviousEvent());
}

}  // namespace

void addRunCommands(Commands& commands, Runs& runs) {
    commands.add({"run.start", Runs::tr("Run"), "Run", "play", Runs::tr("Runs all stages of the scene."),
                  {QKeySequence(Qt::Key_F5)}},
                 [&runs] { runs.start(); });
    commands.add({"run.pause", Runs::tr("Pause run"), "Run", "pause", Runs::tr("Pauses or continues the run."),
                  {QKeySequence(Qt::Key_F6)}},
                 [&runs] { runs.pauseOrGoOn(); });
    commands.add({"run.step", Runs::tr("Single step"), "Run", "step",
                  Runs::tr("Runs one step, then pauses."), {QKeySequence(Qt::Key_F7)}},
                 [&runs] { runs.step(); });
    commands.add({"run.stop", Runs::tr("Stop run"), "Run", "stop", Runs::tr("Stops the run; results so far are kept."),
                  {QKeySequence("Shift+F5")}},
                 [&runs] { runs.stop(); });
    for (const auto signal : {&Runs::sessionChanged, &Runs::sceneChanged})
        QObject::connect(&runs, signal, &commands, [&] { enableRunCommands(commands, runs); });
    enableRunCommands(commands, runs);
}

void addTimeCommands(Commands& commands, TimeCursor& cursor) {
    const auto add = [&](const char* id, const QString& text, const char* icon, const QString& help,
                         const QKeySequence& key, std::function<void()> run) {
        commands.add({id, text, "Results", icon, help, {key}, false, "time"}, std::move(run));
    };
    add("time.play", TimeCursor::tr("Play or pause"), "play",
        TimeCursor::tr("Plays the frames in sequence, or pauses."), QKeySequence(Qt::Key_Space),
        [&cursor] { cursor.playOrPause(); });
    add("time.next", TimeCursor::tr("Next frame"), "step", TimeCursor::tr("Shows the next frame."),
        QKeySequence(Qt::Key_Period), [&cursor] { cursor.step(1); });
    add("time.previous", TimeCursor::tr("Previous frame"), "", TimeCursor::tr("Shows the previous frame."),
        QKeySequence(Qt::Key_Comma), [&cursor] { cursor.step(-1); });
    add("time.home", TimeCursor::tr("First frame"), "home", TimeCursor::tr("Shows the first frame of the run."),
        QKeySequence(Qt::Key_Home), [&cursor] { cursor.home(); });
    add("time.end", TimeCursor::tr("Last frame"), "end",
        TimeCursor::tr("Shows the last frame, or follows a run in progress."), QKeySequence(Qt::Key_End),
        [&cursor] { cursor.end(); });
    add("time.nextEvent", TimeCursor::tr("Next event"), "",
        TimeCursor::tr("Shows the next event; skips joint slips, joint openings and re-sticks unless there are no "
                       "other events."),
        QKeySequence(Qt::Key_N), [&cursor] { cursor.nextEvent(); });
    add("time.previousEvent", TimeCursor::tr("Previous event"), "",
        TimeCursor::tr("Shows the previous event; skips joint slips, joint openings and re-sticks unless there are no "
                       "other events."),
        QKeySequence("Shift+N"), [&cursor] { cursor.previousEvent(); });
    add("time.bookmark", TimeCursor::tr("Bookmark frame"), "bookmark",
        TimeCursor::tr("Adds or removes a bookmark at this frame on the timeline."), QKeySequence("Ctrl+B"),
        [&cursor] { cursor.toggleBookmark(); });
    add("time.compare", TimeCursor::tr("Compare from here"), "",
        TimeCursor::tr("Sets cursor B at this frame, so that other frames can be compared with it. Repeat the command "
                       "to remove cursor B."),
        QKeySequence("Shift+B"), [&cursor] { cursor.toggleCursorB(); });
    const auto enable = [&] { enableTimeCommands(commands, cursor); };
    for (const auto signal : {&TimeCursor::runChanged, &TimeCursor::moved, &TimeCursor::runGrew, &TimeCursor::changed})
        QObject::connect(&cursor, signal, &commands, enable);
    enable();
}

}  // namespace keyblock
