// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands and their options. Every command prints its own output and returns the
// exit code of the program; errors that it does not handle itself are thrown.
#pragma once

#include "app/cli/exit_codes.h"
#include "solver/files/drawing/section_import.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace keyblock::cli {

enum class ProgressKind { Automatic, Bar, Json, None };

struct RunOptions {
    std::filesystem::path scene;
    std::optional<std::filesystem::path> out;  // run store; null: the scene's path with the extension .kbrun
    std::vector<std::string> overrides;  // path=value
    int threads = 0;  // 0: one per hardware thread
    ProgressKind progress = ProgressKind::Automatic;  // a bar on a terminal, otherwise none
    bool resume = false;  // resume the run in an existing run store
    bool overwrite = false;
    bool failOnCollapse = false;  // exit with `DoesNotStand` if the scene is not stable
    bool estimateError = false;  // run again with finer settings and estimate the errors of the quantities
};

struct CheckOptions {
    std::filesystem::path scene;
    std::vector<std::string> overrides;
    bool all = false;  // list every note about cutting
    bool json = false;
};

struct InfoOptions {
    std::filesystem::path run;
    bool json = false;
};

struct ExportOptions {
    std::filesystem::path run;
    // one of the next four is given
    std::optional<std::string> table;
    std::optional<std::string> figure;
    std::optional<std::filesystem::path> vtk;  // folder
    std::optional<std::filesystem::path> animation;  // video file, or folder for its images
    std::optional<std::string> bolt;
    std::optional<std::string> stage;
    std::optional<std::string> at;
    std::optional<int> perSecond;  // frames per second of an animation
    // the next five are for figures and animations only
    std::optional<std::string> quantity;
    std::optional<double> width;  // [mm]
    std::optional<int> dpi;
    std::optional<double> deformed;  // magnification of displacements
    bool whole = false;
    std::vector<std::filesystem::path> references;  // CSV files with curves for comparison in the figure `curves`
    std::filesystem::path out;  // file for a table or figure
    bool overwrite = false;  // replace existing files with the data of a figure
};

struct ImportOptions {
    std::filesystem::path file;
    ImportSettings settings;
    std::filesystem::path out;
    bool overwrite = false;  // replace an existing file
    bool all = false;  // list every entity that was not imported
};

struct SafetyOptions {
    std::filesystem::path scene;
    std::optional<std::filesystem::path> out;  // folder; null: next to the scene, its name followed by -safety
    bool overwrite = false;
    std::vector<std::string> overrides;
    int threads = 0;  // 0: one per hardware thread
    ProgressKind progress = ProgressKind::Automatic;
    bool json = false;
};

struct TradeOptions {
    std::filesystem::path scene;
    std::filesystem::path out;  // folder
    std::optional<double> budget;  // [s] for all runs together; null: no limit
    std::vector<std::string> overrides;
    ProgressKind progress = ProgressKind::Automatic;
};

struct CompareOptions {
    std::filesystem::path a, b;  // run stores
    bool json = false;
};

struct ReportOptions {
    std::filesystem::path run;  // run store, or folder of a sweep
    std::filesystem::path out;  // .pdf or .html
    std::optional<std::filesystem::path> layout;  // template
    std::string project, author, date;  // for the title block; empty: left out
    bool overwrite = false;
};

struct SweepPlanOptions {
    std::filesystem::path study;
    std::filesystem::path out;  // folder
};

struct SweepRunOptions {
    std::filesystem::path sweep;  // folder
    std::optional<std::string> index;  // N or N-M; null: the cases of the task SLURM_ARRAY_TASK_ID
    int threads = 1;
};

struct SweepStatusOptions {
    std::filesystem::path sweep;
    bool json = false;
};

struct SweepCollectOptions {
    std::filesystem::path sweep;
    std::vector<std::string> scatter;  // pairs X,Y of columns
};

struct StressOptions {
    std::filesystem::path scene;
    std::vector<std::string> overrides;
    ProgressKind progress = ProgressKind::Automatic;
    bool json = false;
};

struct VerifyOptions {
    std::vector<std::string> names;  // names of cases; empty: all cases
    bool paper = false;  // show the tables of the paper instead of the cases
    bool extremes = false;  // run scenes to the limits of the method instead of the cases
    int random = 0;  // random combinations of extremes
    std::uint64_t seed = 1;  // of the random combinations
    std::optional<std::filesystem::path> page;  // help page of the limits to write
    bool json = false;
};

struct BoltsOptions {
    std::optional<std::string> name;
};

using Command = std::variant<RunOptions, CheckOptions, InfoOptions, ExportOptions, ImportOptions, SafetyOptions,
                             TradeOptions, StressOptions, CompareOptions, ReportOptions, SweepPlanOptions, SweepRunOptions,
                             SweepStatusOptions, SweepCollectOptions, VerifyOptions, BoltsOptions>;

ExitCode perform(const RunOptions& options);
ExitCode perform(const CheckOptions& options);
ExitCode perform(const InfoOptions& options);
ExitCode perform(const ExportOptions& options);
ExitCode perform(const ImportOptions& options);
ExitCode perform(const SafetyOptions& options);
ExitCode perform(const TradeOptions& options);
ExitCode perform(const CompareOptions& options);
ExitCode perform(const ReportOptions& options);
ExitCode perform(const SweepPlanOptions& options);
ExitCode perform(const SweepRunOptions& options);
ExitCode perform(const SweepStatusOptions& options);
ExitCode perform(const SweepCollectOptions& options);
ExitCode perform(const StressOptions& options);
ExitCode perform(const VerifyOptions& options);
ExitCode perform(const BoltsOptions& options);

}  // namespace keyblock::cli
