// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verbs and their options. Every verb prints for itself and returns the
// program's exit code; what goes wrong outside its own business it throws.
#pragma once

#include "app/cli/exit_codes.h"
#include "solver/files/drawing/section_import.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace keyblock::cli {

enum class ProgressKind { Automatic, Bar, Json, None };

struct RunOptions {
    std::filesystem::path scene;
    std::optional<std::filesystem::path> out;  // null: the scene's name with .kbrun, in the same folder
    std::vector<std::string> overrides;  // path=value
    int threads = 0;  // 0: as many as the machine has
    ProgressKind progress = ProgressKind::Automatic;  // a bar on a terminal, else none
    bool resume = false;  // continue in an existing run store
    bool overwrite = false;
    bool failOnCollapse = false;  // exit with `DoesNotStand`
};

struct CheckOptions {
    std::filesystem::path scene;
    std::vector<std::string> overrides;
    bool all = false;  // every note of the cut
    bool json = false;
};

struct InfoOptions {
    std::filesystem::path run;
    bool json = false;
};

struct ExportOptions {
    std::filesystem::path run;
    std::optional<std::string> table;  // one of these four
    std::optional<std::string> figure;
    std::optional<std::filesystem::path> vtk;  // the folder
    std::optional<std::filesystem::path> animation;  // the file, or the folder of its images
    std::optional<std::string> bolt;
    std::optional<std::string> stage;
    std::optional<std::string> at;
    std::optional<int> perSecond;  // frames of an animation
    std::optional<std::string> quantity;  // of a figure or an animation, as all below
    std::optional<double> width;  // [mm]
    std::optional<int> dpi;
    std::optional<double> deformed;  // factor on displacements
    bool whole = false;
    std::vector<std::filesystem::path> references;  // CSV files drawn with the curves
    std::filesystem::path out;
};

struct ImportOptions {
    std::filesystem::path file;
    ImportSettings settings;
    std::filesystem::path out;
    bool all = false;  // every entity that was not taken
};

struct SafetyOptions {
    std::filesystem::path scene;
    std::optional<std::filesystem::path> out;  // the folder; null: the scene's name with -safety, in the same folder
    bool overwrite = false;
    std::vector<std::string> overrides;
    int threads = 0;  // 0: as many as the machine has
    ProgressKind progress = ProgressKind::Automatic;
    bool json = false;
};

struct VerifyOptions {
    std::vector<std::string> names;  // empty: every case
    bool paper = false;  // the paper's tables instead of the cases
    bool json = false;
};

struct BoltsOptions {
    std::optional<std::string> name;
};

using Command = std::variant<RunOptions, CheckOptions, InfoOptions, ExportOptions, ImportOptions, SafetyOptions,
                             VerifyOptions, BoltsOptions>;

ExitCode perform(const RunOptions& options);
ExitCode perform(const CheckOptions& options);
ExitCode perform(const InfoOptions& options);
ExitCode perform(const ExportOptions& options);
ExitCode perform(const ImportOptions& options);
ExitCode perform(const SafetyOptions& options);
ExitCode perform(const VerifyOptions& options);
ExitCode perform(const BoltsOptions& options);

}  // namespace keyblock::cli
