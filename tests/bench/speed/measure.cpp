// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a scene in memory and prints one JSON object: the CPU time of a step of its
// last stage, next to the time F of one factorization and S of one back-substitution
// of the same scene, so that machines and loads can be compared, and the share of each
// phase of a step, sampled every millisecond. Usage: measure SCENE.
#include "app/start/blas_choice.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/linear_system.h"
#include "solver/engine/step/link_rows.h"
#include "solver/engine/step/phase.h"
#include "solver/engine/step/step_matrix.h"
#include "solver/files/scene/scene_file.h"
#include "solver/results/step_work.h"
#include "solver/run/run.h"

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace keyblock {
namespace {

constexpr int repetitions = 20;  // the median counts

/// CPU time of this thread [ms].
double clockNow() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Median CPU time of an action [ms].
template <class Action>
double medianTime(Action action) {
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
        const double start = clockNow();
        action();
        times.push_back(clockNow() - start);
    }
    std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
    return times[repetitions / 2];
}

/// The matrix of a step of a scene with every contact closed.
class ClosedMatrix {
public:
    explicit ClosedMatrix(const StepProblem& problem) : problem_(problem) {
        for (int i = 0; i < problem.unknowns(); ++i) equations_.push_back(problem.known[i] ? -1 : count_++);
        std::vector<std::pair<int, int>> entries;
        eachEntry([&](int row, int column, double) { entries.emplace_back(row, column); });
        system.analyse(count_, entries, eliminationGroups(problem));
        eachEntry([&](int row, int column, double value) { system.values()[system.slot(row, column)] += value; });
    }

    LinearSystem system;

private:
    /// Calls `visit` with each contribution to the lower triangle, in equations.
    template <class Visit>
    void eachEntry(Visit visit) const {
        const auto add = [&](int i, int j, double value) {
            const int row = equations_[i], column = equations_[j];
            if (row >= 0 && column >= 0 && row >= column) visit(row, column, value);
        };
        for (int block = 0; block < problem_.blocks; ++block)
            for (int i = 0; i < 6; ++i)
                for (int j = 0; j < 6; ++j) add(6 * block + i, 6 * block + j, problem_.blockStiffness[block](i, j));
        for (int node = 0; node < problem_.nodes; ++node)
            for (int i = 0; i < 3; ++i) {
                const int at = problem_.first(problem_.blocks + node) + i;
                add(at, at, problem_.nodeStiffness[node][i]);
            }
        for (const Link& link : problem_.links) addLink(link, add);
    }

    template <class Add>
    void addLink(const Link& link, Add add) const {
        const double weight = link.law.share * link.law.stiffness;
        std::vector<std::pair<int, double>> gradient;
        for (int k = 0; k < problem_.width(link.a); ++k) gradient.emplace_back(problem_.first(link.a) + k, link.ga[k]);
        for (int k = 0; link.b >= 0 && k < problem_.width(link.b); ++k)
            gradient.emplace_back(problem_.first(link.b) + k, link.gb[k]);
        for (const auto& [i, gi] : gradient)
            for (const auto& [j, gj] : gradient) add(i, j, weight * gi * gj);
    }

    const StepProblem& problem_;
    std::vector<int> equations_;  // per unknown: its equation; −1: prescribed
    int count_ = 0;
};

struct UnitTimes {
    double factorization = 0.0, backSubstitution = 0.0;  // [ms]
};

UnitTimes unitTimes(const Scene& scene, double timeStep) {
    const Model model = makeModel(scene);
    State state = makeState(model);
    state.contacts = findContacts(model, state.blocks, {}, 1e-3, true);
    LoadPoint at;
    at.gravity = 1.0;
    const StepProblem problem = buildStep(model, state, Loads{}, at, {Inertia::Shi, timeStep});
    ClosedMatrix matrix(problem);
    if (matrix.system.factor() >= 0) return {};
    const std::vector<double> load(matrix.system.size(), 1.0);
    std::vector<double> x(load.size());
    bool sound = true;
    UnitTimes times;
    times.factorization = medianTime([&] { sound = matrix.system.factor() < 0 && sound; });
    times.backSubstitution = medianTime([&] { matrix.system.solve(load, x); });
    return sound ? times : UnitTimes{};
}

volatile long samples[phases];

void sample(int) { samples[static_cast<int>(currentPhase)] = samples[static_cast<int>(currentPhase)] + 1; }

/// Counts, from now on, the milliseconds of CPU time that the program works on each phase.
void startSampling() {
    struct sigaction action {};
    action.sa_handler = sample;
    action.sa_flags = SA_RESTART;
    sigaction(SIGPROF, &action, nullptr);
    const itimerval everyMillisecond{{0, 1000}, {0, 1000}};
    setitimer(ITIMER_PROF, &everyMillisecond, nullptr);
}

void stopSampling() {
    const itimerval never{};
    setitimer(ITIMER_PROF, &never, nullptr);
}

/// Share of the time per phase.
nlohmann::json shares() {
    constexpr const char* names[phases] = {"other",    "search", "build",  "judge", "sweep",
                                           "assemble", "factor", "update", "solve", "accept"};
    double all = 0.0;
    for (int phase = 0; phase < phases; ++phase) all += static_cast<double>(samples[phase]);
    nlohmann::json share = nlohmann::json::object();
    for (int phase = 0; phase < phases; ++phase)
        share[names[phase]] = all > 0.0 ? static_cast<double>(samples[phase]) / all : 0.0;
    return share;
}

/// Time of the steps of the last stage after its first step, which also takes the start of the stage [ms].
struct StageClock {
    int stage = 0;
    long before = 0;  // steps of earlier stages and of the stage's first step
    double first = 0.0, last = 0.0;
    long steps = 0;
    bool begun = false;

    void look(const Progress& progress) {
        if (progress.stage != stage) {
            before = progress.steps;
            return;
        }
        if (progress.steps == before) return;
        last = clockNow();
        steps = progress.steps;
        if (begun) return;
        first = last, before = steps, begun = true;
        startSampling();
    }

    double perStep() const { return steps > before ? (last - first) / static_cast<double>(steps - before) : 0.0; }
};

/// Keeps no results, whose memory would count as that of the solver; a run writes them to its store.
class CountingSink : public Sink {
public:
    void begin(const Scene&, const HistoryColumns&) override {}
    void stageBegins(int) override {}
    void event(const Event&) override {}
    void history(const HistoryRow&) override {}
    void frame(const Frame& frame) override { blocks = frame.blocks.size(); }
    void stageEnds(const StageResult&) override {}

    std::size_t blocks = 0;
};

nlohmann::json measured(const Scene& scene) {
    CountingSink sink;
    Control control;
    StageClock clock{static_cast<int>(scene.stages.size()) - 1};
    control.progress = [&](const Progress& progress) { clock.look(progress); };
    const double start = clockNow();
    const std::vector<StageResult> results = run(scene, sink, control, {.threads = 1});
    const double whole = clockNow() - start;
    stopSampling();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const Health& health = results.back().health;
    const auto solves = static_cast<double>(std::max(1L, health.steps));
    const double timeStep = scene.stages.back().timeStep.value_or(1e-3);
    const UnitTimes unit = unitTimes(scene, timeStep);
    const bool dynamic = scene.stages.back().kind == StageKind::Dynamic;
    const auto steps = dynamic ? static_cast<double>(std::max(1L, results.back().steps)) : solves;
    const double perStep = dynamic ? clock.perStep() : whole;
    return {{"blocks", sink.blocks},
            {"ms_per_step", perStep},
            {"F_ms", unit.factorization},
            {"S_ms", unit.backSubstitution},
            {"step_in_F",
             dynamic && unit.factorization > 0.0 ? nlohmann::json(perStep / unit.factorization) : nlohmann::json()},
            {"iterations", static_cast<double>(health.passes) / steps},
            {"factorizations", static_cast<double>(health.work.factorizations) / solves},
            {"work", workOf(health.work) / solves},
            {"cuts", health.stepCuts + health.energyCuts},
            {"awake", health.movable > 0
                          ? nlohmann::json(static_cast<double>(health.awake) / static_cast<double>(health.movable))
                          : nlohmann::json()},
            {"shares", shares()},
            {"run_s", 1e-3 * whole},
            {"memory_MB", static_cast<double>(usage.ru_maxrss) / 1024.0}};
}

}  // namespace
}  // namespace keyblock

int main(int argc, char** argv) {
    using namespace keyblock;
    chooseBlas();
    if (argc != 2) return std::fprintf(stderr, "usage: %s SCENE.json\n", argv[0]), 2;
    const SceneReading reading = readSceneFile(argv[1]);
    if (!reading.scene) return std::fprintf(stderr, "%s: the scene has errors\n", argv[1]), 2;
    const Scene& scene = reading.cut ? reading.cut->scene : *reading.scene;
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    std::printf("%s\n", measured(scene).dump().c_str());
}
