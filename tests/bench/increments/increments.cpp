// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the increments that the program chooses with 200 equal ones: forces,
// displacements and the order in which bolts fail, on scenes whose joints slide and
// whose bolts fail. Prints the work of both, of one increment and of ten equal ones.
// Exit code 1: something differs by more than 2 %.
#include "app/start/blas_choice.h"
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace keyblock {
namespace {

constexpr double mostDifference = 0.02;

const std::filesystem::path data = std::filesystem::path(KEYBLOCK_TEST_DATA_DIR) / "increments";
const std::filesystem::path samples = KEYBLOCK_SAMPLES_DIR;

struct Compared {
    std::filesystem::path file;
    int first;  // of the stages whose increments are compared
    int last;  // stage to run
    std::optional<double> tolerance = std::nullopt;  // of the solution; null: that of the scene
};

// At the default tolerance of 1e-4 the drifts with one have differences of 2 % between 100 and 200 increments already.
const std::vector<Compared> scenes{
    {data / "drift-in-two-sets.json", 1, 1},      {data / "drift-under-flat-joints.json", 1, 1, 1e-6},
    {data / "drift-bolted-in-stages.json", 1, 2}, {data / "drift-with-friction-bolts.json", 1, 2},
    {data / "wall-pushed.json", 1, 1},            {data / "wall-pushed-to-and-fro.json", 1, 1},
    {data / "wall-pressed-and-pushed.json", 1, 1}, {samples / "drift-bolted.json", 1, 1, 1e-6},
    {samples / "rebar-20.json", 0, 0},            {samples / "expansion-shell.json", 0, 0},
    {samples / "cone-bolt.json", 0, 0},           {samples / "plate-block.json", 0, 0},
};

using Failure = std::tuple<EventKind, int, int, int>;

struct Run {
    Results results;
    double work = 0.0;
    long steps = 0;
};

/// \param increments of the compared stages; none: chosen by the program.
std::optional<Run> runOf(const Compared& compared, std::optional<int> increments) {
    const SceneReading reading = readSceneFile(compared.file);
    if (!reading.scene) return std::nullopt;
    Scene scene = *reading.scene;
    scene.stages.resize(static_cast<std::size_t>(compared.last) + 1);
    for (std::size_t i = compared.first; i < scene.stages.size(); ++i)
        scene.stages[i].increments = increments;
    scene.output = {};
    if (compared.tolerance) scene.analysis.tolerance = compared.tolerance;
    Run run{runInMemory(scene)};
    for (const StageResult& stage : run.results.stages) {
        if (stage.stage < compared.first) continue;
        run.work += workOf(stage.health.work);
        run.steps += stage.steps;
    }
    return run;
}

double displacementDifference(const Frame& a, const Frame& b) {
    double most = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < b.blocks.size(); ++i) {
        most = std::max(most, (a.blocks[i].displacement - b.blocks[i].displacement).norm());
        largest = std::max(largest, b.blocks[i].displacement.norm());
    }
    return largest > 0.0 ? most / largest : most;
}

/// Force between two blocks, on the one of the lower row.
std::map<std::pair<int, int>, Point> jointForces(const Frame& frame) {
    std::map<std::pair<int, int>, Point> forces;
    for (const ContactFrame& c : frame.contacts) {
        const Point right(c.normal.y(), -c.normal.x());
        const Point onA = c.normalForce * c.normal + c.shearForce * right;
        forces.try_emplace(std::minmax(c.blockA, c.blockB), Point(0.0, 0.0)).first->second +=
            c.blockA < c.blockB ? onA : Point(-onA);
    }
    return forces;
}

double jointForceDifference(const Frame& a, const Frame& b) {
    auto first = jointForces(a);
    double most = 0.0, largest = 0.0;
    for (const auto& [pair, force] : jointForces(b)) {
        const Point other = first.try_emplace(pair, Point(0.0, 0.0)).first->second;
        most = std::max(most, (other - force).norm());
        largest = std::max(largest, force.norm());
        first.erase(pair);
    }
    for (const auto& [pair, force] : first) most = std::max(most, force.norm());
    return largest > 0.0 ? most / largest : most;
}

double boltForceDifference(const Frame& a, const Frame& b) {
    double most = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < b.bolts.size(); ++i)
        for (std::size_t n = 0; n < b.bolts[i].nodes.size(); ++n) {
            const double force = b.bolts[i].nodes[n].axialForce;
            most = std::max(most, std::abs(a.bolts[i].nodes[n].axialForce - force));
            largest = std::max(largest, std::abs(force));
        }
    return largest > 1.0 ? most / largest : 0.0;  // less than a newton: the bolt has failed
}

/// Re-sticking is no failure, and is found at the ends of increments only.
std::vector<Failure> boltFailures(const Results& results) {
    std::vector<Failure> failures;
    for (const Event& e : results.events)
        if (e.bolt >= 0 && e.kind != EventKind::Restick) failures.emplace_back(e.kind, e.bolt, e.node, e.element);
    return failures;
}

bool compare(const Compared& compared) {
    const auto chosen = runOf(compared, std::nullopt), fine = runOf(compared, 200);
    const auto one = runOf(compared, 1), ten = runOf(compared, 10);
    if (!chosen || !fine || !one || !ten) {
        std::printf("%s cannot be read\n", compared.file.c_str());
        return false;
    }
    const Frame &a = chosen->results.frames.back(), &b = fine->results.frames.back();
    const double moved = displacementDifference(a, b), joints = jointForceDifference(a, b), bolts = boltForceDifference(a, b);
    const bool sameOrder = boltFailures(chosen->results) == boltFailures(fine->results);
    const bool passed = std::max({moved, joints, bolts}) <= mostDifference && sameOrder;
    std::printf("%-28s %9.0f %9.0f %9.0f %9.0f %9.2f %9.2f %6ld %8.2f %8.2f %8.2f %5zu %s  %s\n",
                compared.file.stem().c_str(), chosen->work, one->work, ten->work, fine->work, chosen->work / ten->work,
                one->work / ten->work, chosen->steps, 100.0 * moved, 100.0 * joints, 100.0 * bolts,
                boltFailures(fine->results).size(), sameOrder ? "same " : "other", passed ? "passed" : "FAILED");
    std::fflush(stdout);
    return passed;
}

}  // namespace
}  // namespace keyblock

/// \param argv names of scenes, as the table prints them; none: all.
int main(int argc, char** argv) {
    keyblock::chooseBlas();
    std::printf("%-28s %9s %9s %9s %9s %9s %9s %6s %8s %8s %8s %5s %s\n", "", "work", "of 1", "of 10", "of 200",
                "work/10", "1/10", "steps", "moves %", "joints %", "bolts %", "fail", "order");
    bool passed = true;
    for (const keyblock::Compared& scene : keyblock::scenes)
        if (argc < 2 || std::find(argv + 1, argv + argc, scene.file.stem().string()) != argv + argc)
            passed = keyblock::compare(scene) && passed;
    return passed ? 0 : 1;
}
