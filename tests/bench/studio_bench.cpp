// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the window costs a run, and a run the window: processor time of the solver's
// thread over the same steps with the view on and off, by turns; the heartbeat of the
// window while it runs; how soon it stops; memory over ten thousand frames. Takes the
// scene, how long to measure, and settings of the scene as the command line does:
//   keyblock_studio_bench SCENE.json SECONDS [path=value …]
#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/runs/live_run.h"
#include "ui/runs/run_session.h"
#include "ui/runs/runs.h"
#include "ui/window/main_window.h"
#include "ui/window/software_gl.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <utility>
#include <vector>

namespace keyblock {
namespace {

constexpr int looksPerSecond = 10;
constexpr long firstStep = 5;
constexpr long settled = 1000, manyFrames = 10000;

double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0, resident = 0.0;
    file >> pages >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Sleeps between events as the window itself does: a wait that looks round and round would take a whole core.
void waitFor(const std::function<bool()>& done) {
    QTimer look;
    look.start(5);
    while (!done()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

double ownSeconds() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Intervals of a timer of 10 ms, and the processor time that the window took within each: on a machine that others use
/// too, the second tells what the window itself is the cause of.
class Heartbeat {
public:
    Heartbeat() {
        timer_.setTimerType(Qt::PreciseTimer);
        QObject::connect(&timer_, &QTimer::timeout, [this] {
            beats_.push_back(1e-6 * static_cast<double>(clock_.nsecsElapsed()));
            clock_.start();
            const double now = ownSeconds();
            own_.push_back(1e3 * (now - before_));
            before_ = now;
        });
        clock_.start();
        timer_.start(10);
    }
    void tell() {
        const auto at = [](std::vector<double>& values, double share) {
            if (values.empty()) return 0.0;
            std::sort(values.begin(), values.end());
            return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
        };
        std::printf("heartbeat of 10 ms, %zu beats: median %.1f, 99 %% %.1f, longest %.1f ms\n", beats_.size(),
                    at(beats_, 0.5), at(beats_, 0.99), at(beats_, 1.0));
        std::printf("processor time of the window in each: median %.1f, 99 %% %.1f, most %.1f ms\n", at(own_, 0.5),
                    at(own_, 0.99), at(own_, 1.0));
    }

private:
    QTimer timer_;
    QElapsedTimer clock_;
    std::vector<double> beats_, own_;  // [ms]
    double before_ = ownSeconds();
};

struct Spent {
    double seconds = 0.0;
    long steps = 0;
    double perStep() const { return 1e3 * seconds / static_cast<double>(std::max(1L, steps)); }
};

/// What the solver's thread takes from the first steps to step `last`, or for so many seconds.
Spent spent(const RunSession& session, double seconds, long last) {
    waitFor([&] { return session.isOver() || session.steps() >= firstStep; });
    const double before = session.threadSeconds();
    const long from = session.steps();
    Spent spent;
    const auto look = [&] {
        if (session.isOver()) return true;
        spent = {session.threadSeconds() - before, session.steps() - from};
        return from + spent.steps >= last || spent.seconds >= seconds;
    };
    waitFor(look);
    return spent;
}

void endRun(RunSession& session) {
    session.stop();
    waitFor([&] { return session.isOver(); });
}

void measureStop(RunSession& session) {
    QElapsedTimer clock;
    clock.start();
    endRun(session);
    std::printf("stop after %.0f ms\n", 1e-6 * static_cast<double>(clock.nsecsElapsed()));
}

void show(MainWindow& window, Scene scene, const QString& folder, const QString& name) {
    auto* document = window.findChild<Document*>();
    document->startNew(std::move(scene), name);
    document->save(folder + "/" + name + ".json");
    waitFor([&] { return document->checkIsCurrent(); });
}

/// A run of the scene that is shown; null where it does not begin.
RunSession* start(MainWindow& window) {
    auto* runs = window.findChild<Runs*>();
    runs->start();
    waitFor([&] { return !runs->isRunning() || runs->session()->run(); });
    if (runs->isRunning()) return runs->session();
    std::cerr << runs->session()->message().toStdString() << '\n';
    return nullptr;
}

/// The same steps again and again, as one step may cost a hundred times another: runs with the view on and off by turns.
void measureCost(MainWindow& window, double seconds) {
    Spent on, off;
    long last = std::numeric_limits<long>::max();
    bool isWarm = false;  // the first run only touches memory for the others
    for (const bool isOn : {true, true, false, false, true, true, false}) {
        RunSession* session = start(window);
        if (!session) return;
        session->setLooksPerSecond(isOn ? looksPerSecond : 0);
        const Spent part = spent(*session, seconds / 7.0, last);
        last = std::min(last, firstStep + part.steps);
        endRun(*session);
        if (!std::exchange(isWarm, true)) continue;
        Spent& sum = isOn ? on : off;
        sum = {sum.seconds + part.seconds, sum.steps + part.steps};
        std::printf("  view %s: %.3f ms a step, %ld steps\n", isOn ? "on" : "off", part.perStep(), part.steps);
    }
    std::printf("solver thread, ms a step: view on %.3f, off %.3f, %+.1f %%\n", on.perStep(), off.perStep(),
                100.0 * (on.perStep() / off.perStep() - 1.0));
}

/// The window as a user has it: it looks as often as it can.
void measureHeart(MainWindow& window, double seconds) {
    RunSession* session = start(window);
    if (!session) return;
    std::printf("%zu blocks\n", session->run()->blockNames().size());
    Heartbeat heart;
    QElapsedTimer clock;
    clock.start();
    waitFor([&] { return session->isOver() || 1e-3 * static_cast<double>(clock.elapsed()) >= seconds; });
    heart.tell();
    if (!session->isOver()) measureStop(*session);
}

void measureMemory(MainWindow& window, const QString& folder) {
    SceneReading reading = readSceneFile(std::string(KEYBLOCK_SAMPLES_DIR) + "/incline.json");
    if (!reading.scene) return;
    reading.scene->output.every.reset();
    reading.scene->output.frames = static_cast<int>(manyFrames + settled);
    for (Stage& stage : reading.scene->stages) stage.timeStep = stage.duration / static_cast<double>(manyFrames + settled);
    show(window, *reading.scene, folder, "frames");
    RunSession* started = start(window);
    if (!started) return;
    RunSession& session = *started;
    const auto frames = [&] { return static_cast<long>(session.run()->frames().size()); };
    waitFor([&] { return session.isOver() || frames() >= settled; });
    const double early = residentMegabytes();
    waitFor([&] { return session.isOver() || frames() >= manyFrames; });
    std::printf("memory: %.1f MB at %ld frames, %.1f MB at %ld\n", early, settled, residentMegabytes(), frames());
}

int measure(int argc, char** argv) {
    const std::vector<std::string> overrides(argv + std::min(argc, 3), argv + argc);
    const SceneReading reading = readSceneFile(argv[1], overrides);
    if (!reading.scene) {
        for (const Problem& problem : reading.problems) std::cerr << oneLine(problem) << '\n';
        return 1;
    }
    QTemporaryDir folder;
    Themes themes;
    MainWindow window(themes);
    window.show();
    Runs& runs = *window.findChild<Runs*>();
    runs.setThreads(1);  // so that all of the solver's work is its thread's
    show(window, *reading.scene, folder.path(), "scene");
    measureCost(window, std::atof(argv[2]));
    runs.setThreads(0);
    measureHeart(window, std::atof(argv[2]) / 2.0);
    measureMemory(window, folder.path());
    runs.stopForClosing();
    return 0;
}

}  // namespace
}  // namespace keyblock

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "keyblock_studio_bench SCENE.json SECONDS [path=value ...]\n";
        return 2;
    }
    keyblock::leaveProcessorsToRuns();
    QApplication application(argc, argv);
    QCoreApplication::setApplicationName("keyblock-studio-bench");
    QCoreApplication::setOrganizationName("keyblock");
    return keyblock::measure(argc, argv);
}
