// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/safety_folder.h"

#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/atomic_file.h"
#include "solver/results/csv.h"
#include "solver/results/result_names.h"
#include "solver/run/checkpoint.h"
#include "solver/scene/solved_blocks.h"

namespace keyblock::cli {

namespace {

namespace fs = std::filesystem;

/// Passes all calls on to two sinks.
class Both : public Sink {
public:
    Both(Sink& one, Sink& other) : one_(one), other_(other) {}

    void begin(const Scene& scene, const HistoryColumns& columns) override {
        one_.begin(scene, columns);
        other_.begin(scene, columns);
    }
    void stageBegins(int stage) override {
        one_.stageBegins(stage);
        other_.stageBegins(stage);
    }
    void event(const Event& event) override {
        one_.event(event);
        other_.event(event);
    }
    void history(const HistoryRow& row) override {
        one_.history(row);
        other_.history(row);
    }
    void frame(const Frame& frame) override {
        one_.frame(frame);
        other_.frame(frame);
    }
    void stageEnds(const StageResult& result) override {
        one_.stageEnds(result);
        other_.stageEnds(result);
    }

private:
    Sink &one_, &other_;
};

bool isOurs(const std::string& name) {
    return name == "stands.kbrun" || name == "fails.kbrun" || name == "safety.csv";
}

const fs::path& freeFolder(const fs::path& folder, bool overwrite) {
    if (!overwrite && fs::exists(folder))
        throw CannotWrite("cannot write " + folder.string() + ": it already exists; use --overwrite, or another --out");
    return folder;
}

}  // namespace

SafetyFolder::SafetyFolder(const fs::path& folder, bool overwrite) : folder_(freeFolder(folder, overwrite), isOurs) {}

void SafetyFolder::record(Sink& other, const std::function<void(Sink&)>& run) {
    RunStoreWriter store(probe(), true);
    Both both(store, other);
    run(both);
    store.close();
}

void SafetyFolder::keep(const SafetyRun& run) {
    runs_.push_back(run);
    if (run.end.outcome != Outcome::Undecided)
        fs::rename(probe(), folder_.path() / (run.stands ? "stands.kbrun" : "fails.kbrun"));
}

void SafetyFolder::finish(const Scene& scene) {
    std::error_code ignored;
    fs::remove(probe(), ignored);
    const std::vector<std::string> names = blockNames(scene);
    writeAtomically(folder_.path() / "safety.csv", [&](std::ostream& out) {
        CsvWriter csv(out);
        for (const char* column : {"factor", "outcome", "stands", "stage", "block", "moved_m", "solves"}) csv.text(column);
        csv.endRow();
        for (const SafetyRun& run : runs_) {
            csv.number(run.factor).text(wordOf(run.end.outcome)).integer(run.stands ? 1 : 0);
            csv.text(stageName(scene, run.end.stage)).text(blockName(names, run.end.farthest.block));
            csv.number(run.end.farthest.moved).integer(run.end.health.steps).endRow();
        }
    });
    folder_.putInPlace();
}

}  // namespace keyblock::cli
