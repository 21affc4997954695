// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quantities are read back from the run store, so that a resumed case gives the same
// numbers as one that was never interrupted.
#include "solver/study/case_run.h"

#include "solver/files/atomic_file.h"
#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/resumption.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/run_store_writer.h"
#include "solver/results/result_names.h"
#include "solver/results/verdict.h"
#include "solver/run/checkpoint_check.h"
#include "solver/run/safety.h"
#include "solver/scene/enum_names.h"
#include "solver/study/case_starts.h"
#include "solver/study/case_table.h"
#include "solver/study/failure_criterion.h"
#include "solver/study/folder_lock.h"
#include "solver/study/thin_store.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <new>
#include <stdexcept>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

double cpuSecondsSoFar() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string hostName() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// `quantities=[…]`, so that the history has the columns of all that is measured.
std::string quantitiesOverride(const std::vector<std::string>& quantities) {
    JsonList list;
    for (const std::string& quantity : quantities) list.push_back({quantity});
    return "quantities=" + jsonLine({std::move(list)});
}

std::vector<std::string> ownQuantities(const std::string& sceneText) {
    const JsonReading json = readJson(sceneText);
    const JsonNode* node = json.root ? findMember(*json.root, "quantities") : nullptr;
    const auto* list = node ? std::get_if<JsonList>(&node->value) : nullptr;
    std::vector<std::string> quantities;
    if (!list) return quantities;
    for (const JsonNode& item : *list)
        if (const auto* text = std::get_if<std::string>(&item.value)) quantities.push_back(*text);
    return quantities;
}

/// Cells of the parameters of a case. \throws CannotRead
std::vector<std::string> rowOfCase(const SweepRun& run, long number) {
    return readCaseRow(run.sweep.folder / sweepCasesName, number, run.sweep.study.parameters.size());
}

CaseScene sceneOfRow(const SweepRun& run, long number, const std::vector<std::string>& row) {
    const Study& study = run.sweep.study;
    std::vector<std::string> overrides = overridesOf(study, row);
    overrides.push_back(quantitiesOverride(run.recorded));
    CaseScene scene;
    scene.read = readSceneText(run.sweep.sceneText, sweepSceneName, overrides, std::nullopt);
    if (!scene.read.scene || study.faults.empty()) return scene;
    scene.faults = faultsOf(study, number, scene.read);
    scene.faultMeasures = faultMeasures(study, scene.faults, scene.read);
    if (scene.faults.empty()) return scene;
    const std::string text = wholeSceneText(withFaults(scene.read, scene.faults));
    scene.read = readSceneText(text, "the scene with its faults", {}, std::nullopt);
    return scene;
}

/// One case while it is run.
class RunningCase {
public:
    /// \param row the cells of the case in the table of cases.
    RunningCase(const SweepRun& run, long number, std::vector<std::string> row, Control& control,
                SweepCaseResult& result)
        : row_(std::move(row)), run_(run), study_(run.sweep.study), number_(number), control_(control), result_(result),
          store_(caseFolder(run.sweep.folder, number) / "run.kbrun") {}

    /// \return false if it was interrupted.
    bool perform() {
        if (!readScene()) return true;
        if (!runScene()) return false;
        const RunStore store(store_);
        readResults(store);
        return !study_.safety || findSafety();
    }

    void settleStore() const {
        std::error_code ignored;
        if (study_.keep == KeptStores::None)
            for (const char* ending : {"", "-wal", "-shm", "-journal"}) fs::remove(store_.string() + ending, ignored);
        if (study_.keep == KeptStores::Thin && result_.outcome != CaseOutcome::Invalid && fs::exists(store_, ignored))
            thinStore(store_, *read_.scene);
    }

    /// Reads the criterion and gives the case its verdict, when all values are known.
    void decide() {
        if (study_.fails.empty() || !read_.scene) return;
        const FailureReading reading = readFailure(study_.fails, solved());
        if (reading.criterion)
            result_.fails = fails(
                *reading.criterion, [&](const std::string& quantity) { return valueOf(quantity); }, lostBolt_);
    }

private:
    const Scene& solved() const { return read_.cut ? read_.cut->scene : *read_.scene; }

    /// \return false if the case has no valid scene, which is its result.
    bool readScene() {
        CaseScene scene = sceneOfRow(run_, number_, row_);
        read_ = std::move(scene.read);
        result_.faults = std::move(scene.faults);
        result_.faultMeasures = std::move(scene.faultMeasures);
        if (read_.scene && !read_.scene->stages.empty()) return true;
        result_.outcome = CaseOutcome::Invalid;
        for (const Problem& problem : read_.problems)
            if (problem.severity == Severity::Error && result_.reason.empty()) result_.reason = oneLine(problem);
        if (result_.reason.empty()) result_.reason = "the scene has no stages";
        return false;
    }

    /// A store of another scene or build, or a damaged one, is of no use: the case starts again.
    Resumption resumption() const {
        try {
            return resumptionOf(store_, *read_.scene);
        } catch (const CannotRead&) {
            std::error_code ignored;
            fs::remove(store_, ignored);
            return {};
        }
    }

    std::vector<StageResult> runInto(const std::optional<Checkpoint>& from) {
        RunStoreWriter store(store_, true);
        const std::vector<StageResult> stages = keyblock::run(
            *read_.scene, store, control_, {run_.threads, read_.cut ? &*read_.cut : nullptr}, from ? &*from : nullptr);
        store.close();
        return stages;
    }

    bool runScene() {
        const Resumption from = resumption();
        if (from.finished) return true;
        const CaseStarts starts(store_.parent_path(), from.checkpoint ? from.checkpoint->written.historyRows : -1);
        if (starts.isHopeless())
            throw std::runtime_error("the program ended without a result " + std::to_string(mostStarts) +
                                     " times at the same point of the run; it may lack memory");
        std::vector<StageResult> stages;
        try {
            stages = runInto(from.checkpoint);
        } catch (const UnfitCheckpoint&) {
            stages = runInto(std::nullopt);
        }
        starts.forget();
        return std::ranges::none_of(stages, [](const StageResult& r) { return r.outcome == Outcome::Stopped; });
    }

    void noteOutcome(const std::vector<StageRecord>& stages) {
        for (const StageRecord& record : stages) {
            const StageResult& stage = record.result;
            result_.steps += stage.steps;
            if (!record.ended || endedAsPlanned(stage.outcome) || endedUnstable(stage.outcome)) continue;
            result_.outcome = stage.outcome == Outcome::Failed  ? CaseOutcome::NumericalFailure
                              : stage.outcome == Outcome::Limit ? CaseOutcome::Limit
                                                                : CaseOutcome::Undecided;
            result_.reason = "stage '" + stageName(solved(), stage.stage) + "': " + std::string(wordOf(stage.outcome)) +
                             (stage.message.empty() ? "" : ", " + stage.message);
        }
    }

    void readResults(const RunStore& store) {
        const std::vector<HistoryRow> history = store.history();
        const std::vector<Event> events = store.events();
        const std::vector<StageRecord> stages = store.stages();
        const RecordedRun recorded{store.scene(), history, events, stages};
        noteOutcome(stages);
        result_.stands = verdictOf(stages, store.scene()).stands;
        lostBolt_ = lostBolt(events);
        for (const std::string& quantity : run_.recorded) measured_.emplace_back(quantity, measure(quantity, recorded));
        for (const std::string& quantity : run_.quantities) result_.values.push_back(measurementOf(quantity));
    }

    const Measurement& measurementOf(const std::string& quantity) const {
        static const Measurement none;
        const auto found = std::ranges::find(measured_, quantity, &std::pair<std::string, Measurement>::first);
        return found == measured_.end() ? none : found->second;
    }

    std::optional<double> valueOf(const std::string& quantity) const {
        if (quantity == "factor_of_safety") return result_.safetyLower;
        return measurementOf(quantity).value;
    }

    /// \return false if the search was interrupted.
    bool findSafety() {
        const auto trial = [&](const Scene& reduced, double, Sink& sink) {
            keyblock::run(reduced, sink, control_, {run_.threads, nullptr});
        };
        const SafetyFactor found = findSafetyFactor(*read_.scene, trial);
        if (found.cutShort == Outcome::Stopped) return false;
        result_.safetyLower = found.lower;
        result_.safetyUpper = found.upper;
        for (std::size_t i = 0; i < run_.quantities.size(); ++i) {
            if (run_.quantities[i] != "factor_of_safety") continue;
            result_.values[i] = {
                found.lower, found.lower ? "" : "no factor was found at which the scene is stable", {}};
        }
        return true;
    }

    std::vector<std::string> row_;
    const SweepRun& run_;
    const Study& study_;
    long number_;
    Control& control_;
    SweepCaseResult& result_;
    fs::path store_;
    SceneReading read_;
    std::vector<std::pair<std::string, Measurement>> measured_;
    bool lostBolt_ = false;
};

void makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw CannotWrite(cannotWriteText(folder, error.value()));
}

/// Performs a case, and turns what goes wrong in it into its reason.
bool performed(RunningCase& running, SweepCaseResult& result) {
    const auto failed = [&](const std::string& reason) {
        result.outcome = CaseOutcome::Error;
        result.reason = reason;
    };
    try {
        return running.perform();
    } catch (const CannotWrite&) {
        throw;
    } catch (const std::bad_alloc&) {
        failed("out of memory");
    } catch (const std::exception& error) {
        failed(error.what());
    }
    return true;
}

}  // namespace

SweepRun sweepRunOf(const Sweep& sweep, int threads) {
    SweepRun run{sweep, sweep.study.quantities, ownQuantities(sweep.sceneText), threads};
    if (run.quantities.empty()) run.quantities = run.recorded;
    const auto record = [&](const std::string& quantity) {
        if (!std::ranges::count(run.recorded, quantity)) run.recorded.push_back(quantity);
    };
    for (const std::string& quantity : run.quantities) record(quantity);
    if (sweep.study.fails.empty()) return run;
    const SceneReading scene = readSceneText(sweep.sceneText, sweepSceneName, {}, std::nullopt);
    if (!scene.scene) return run;
    const FailureReading failure = readFailure(sweep.study.fails, scene.cut ? scene.cut->scene : *scene.scene);
    if (failure.criterion)
        for (const std::string& quantity : quantitiesOf(*failure.criterion)) record(quantity);
    return run;
}

CaseScene caseScene(const SweepRun& run, long number) { return sceneOfRow(run, number, rowOfCase(run, number)); }

CaseEnd runCase(const SweepRun& run, long number, Control& control, SweepCaseResult& result) {
    const fs::path folder = caseFolder(run.sweep.folder, number);
    makeFolder(folder);
    const FolderLock lock(folder);
    std::error_code error;
    if (!lock.isHeld() || fs::exists(summaryPath(run.sweep.folder, number), error)) return CaseEnd::Busy;
    result = {};
    result.number = number;
    const double cpu = cpuSecondsSoFar();
    const auto begun = std::chrono::steady_clock::now();
    RunningCase running(run, number, rowOfCase(run, number), control, result);
    if (!performed(running, result)) return CaseEnd::Interrupted;
    running.decide();
    if (result.values.empty())
        result.values.assign(run.quantities.size(), Measurement{std::nullopt, "the case has no results", {}});
    result.faultMeasures.resize(run.sweep.study.faults.size());
    running.settleStore();
    fs::remove(folder / "starts", error);
    result.cpuSeconds = cpuSecondsSoFar() - cpu;
    result.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    result.host = hostName();
    writeCaseResult(summaryPath(run.sweep.folder, number), result, run.sweep.plan.hash, run.quantities);
    return CaseEnd::Done;
}

}  // namespace keyblock
