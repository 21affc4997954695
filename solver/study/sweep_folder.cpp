// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/sweep_folder.h"

#include "solver/engine/step/blas_kernel.h"
#include "solver/files/atomic_file.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/part_folder.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/build_id.h"
#include "solver/files/sha256.h"
#include "solver/files/text_file.h"
#include "solver/run/write_error.h"
#include "solver/study/case_plan.h"
#include "solver/study/case_table.h"
#include "solver/study/sweep_scripts.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace keyblock {

namespace {

namespace fs = std::filesystem;
using PlanJson = nlohmann::ordered_json;

constexpr long casesInAFolder = 1000;
const TextFileLimits frozenLimits{longestJson, "plan the sweep again", "plan the sweep again"};

void putText(const fs::path& path, const std::string& text) {
    writeAtomically(path, [&](std::ostream& out) { out << text; });
}

void makeExecutable(const fs::path& path) {
    std::error_code ignored;
    fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add,
                    ignored);
}

std::string planText(const SweepPlan& plan) {
    const PlanJson json{{"format", "keyblock-sweep"},
                        {"version", 1},
                        {"cases", plan.cases},
                        {"cases_per_task", plan.casesPerTask},
                        {"kernel", plan.kernel},
                        {"build", plan.build},
                        {"scene_sha256", plan.sceneHash},
                        {"study_sha256", plan.studyHash},
                        {"cases_sha256", plan.casesHash}};
    return json.dump(1) + "\n";
}

[[noreturn]] void failPlan(const fs::path& path, const std::string& why) {
    throw CannotRead("cannot read " + path.string() + ": " + why + "; plan the sweep again");
}

std::string frozenText(const fs::path& path, const std::string& hash) {
    std::string text = readTextFile(path, frozenLimits);
    if (sha256(text) != hash) failPlan(path, "it was changed after the sweep was planned");
    return text;
}

std::string padded(long number, std::size_t width) {
    std::string text = std::to_string(number);
    return std::string(text.size() < width ? width - text.size() : 0, '0') + text;
}

}  // namespace

CaseRange casesOfTask(const SweepPlan& plan, long task) {
    return {(task - 1) * plan.casesPerTask + 1, std::min(task * plan.casesPerTask, plan.cases)};
}

SweepPlan planSweep(const fs::path& folder, const StudyReading& read, const std::string& program) {
    const Study& study = *read.study;
    const CasePlan cases(study);
    const std::string table = caseTable(study, cases);
    SweepPlan plan;
    plan.cases = cases.cases();
    plan.casesPerTask = study.plan.casesPerTask.value_or(static_cast<int>((plan.cases + mostTasks - 1) / mostTasks));
    plan.kernel = blasKernel();
    plan.build = buildId();
    plan.sceneHash = sha256(read.sceneText);
    plan.studyHash = sha256(read.text);
    plan.casesHash = sha256(table);
    const std::string text = planText(plan);
    plan.hash = sha256(text);
    const PartFolder part(folder, [](const std::string&) { return false; });
    putText(part.path() / sweepSceneName, read.sceneText);
    putText(part.path() / sweepStudyName, read.text);
    putText(part.path() / sweepCasesName, table);
    putText(part.path() / sweepPlanName, text);
    putText(part.path() / "submit.sbatch", slurmScript(plan, study.title, program));
    putText(part.path() / "run-parallel.sh", parallelScript(plan, program));
    makeExecutable(part.path() / "run-parallel.sh");
    std::error_code error;
    if (!fs::create_directory(part.path() / "logs", error))
        throw CannotWrite(cannotWriteText(folder / "logs", error.value()));
    part.putInPlace();
    return plan;
}

SweepPlan readSweepPlan(const fs::path& folder) {
    const fs::path path = folder / sweepPlanName;
    const std::string text = readTextFile(path, {longestJson, "give the folder of a sweep", "plan the sweep again"});
    SweepPlan plan;
    try {
        const PlanJson json = PlanJson::parse(text);
        if (json.at("format") != "keyblock-sweep" || json.at("version") != 1)
            failPlan(path, "it is not a sweep of this version");
        json.at("cases").get_to(plan.cases);
        json.at("cases_per_task").get_to(plan.casesPerTask);
        json.at("kernel").get_to(plan.kernel);
        json.at("build").get_to(plan.build);
        json.at("scene_sha256").get_to(plan.sceneHash);
        json.at("study_sha256").get_to(plan.studyHash);
        json.at("cases_sha256").get_to(plan.casesHash);
    } catch (const PlanJson::exception&) {
        failPlan(path, "the file is damaged");
    }
    if (plan.cases < 1 || plan.casesPerTask < 1) failPlan(path, "the file is damaged");
    plan.hash = sha256(text);
    return plan;
}

Sweep openSweep(const fs::path& folder) {
    Sweep sweep{folder, readSweepPlan(folder), {}, {}};
    sweep.sceneText = frozenText(folder / sweepSceneName, sweep.plan.sceneHash);
    sweep.study = readCheckedStudy(frozenText(folder / sweepStudyName, sweep.plan.studyHash),
                                   (folder / sweepStudyName).string());
    return sweep;
}

fs::path caseFolder(const fs::path& sweep, long number) {
    return sweep / sweepRunsName / padded(number / casesInAFolder, 4) / padded(number, 6);
}

fs::path summaryPath(const fs::path& sweep, long number) { return caseFolder(sweep, number) / "summary.json"; }

}  // namespace keyblock
