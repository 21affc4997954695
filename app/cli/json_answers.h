// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The answers in JSON, with the fixed keys that scripts read. More keys may come;
// none goes.
#pragma once

#include "solver/files/run_store/run_store.h"
#include "solver/files/scene/scene_file.h"
#include "solver/run/model_summary.h"
#include "solver/run/safety.h"
#include "solver/scene/problem.h"
#include "solver/verify/verify.h"

#include <optional>
#include <span>
#include <string>

namespace keyblock::cli {

/// `problems[] {severity, pointer, line, message, remedy}`; a line that is not known is null. Of a domain that could be
/// cut also `cut {blocks, vertices, edges, area_m2, tolerance_m, min_area_m2, min_width_m, open_blocks, splits,
/// reports[] {kind, x_m, y_m, message}}`; of a scene without errors `census {blocks, cells, plates, fixed, contacts,
/// bolts, nodes, unknowns {blocks, plates, bolts}, left_out[] {what, why, saves}, estimate {seconds, seconds_least,
/// seconds_most, memory_MB, pass_seconds, step_seconds, stages[] {name, steps, passes, least, most}, assumes[]}}`.
std::string checkJson(const SceneReading& reading, const std::optional<ModelSummary>& summary);

/// `scene_hash, stages[] {name, kind, outcome, time_s, steps}, frames, events {kind: count}, health {…}, verdict {stands,
/// blocks[] {block, mode, moved_m, weight_N}, joints[] {block_a, block_b, mode, slip_m, opening_m}, bolts[] {bolt, event,
/// stage, time_s}}, worst_balance {block, ratio, force_N, stage}, warnings[] {stage, message}, bolts[] {bolt, axial_N,
/// shear_N, moment_Nm, axial_at_m, stage, time_s, use {steel, shear, bond, plate}, governs, holds[]}`; what is not
/// known yet of a stage that has not ended is null. Forces are of one bolt, the largest over the run with their sign;
/// `use` is a share of the strength, null where there is none.
std::string infoJson(const RunStore& store);

/// `cases[] {name, quantity, measured, expected, tolerance, relative, passed, seconds}`.
std::string casesJson(std::span<const CaseResult> results);

/// `tables[] {title, rows[] {quantity, unit, paper, reference, keyblock, tolerance, passed}}`.
std::string paperJson(std::span<const PaperTable> tables);

/// `reduce, tolerance, lower, upper, outcome, runs[] {factor, stands, stage, outcome, steps, message}, mode {blocks[]
/// {name, movement, displacement_m, rotation_rad}, joints[] {blocks, joint_material, x_m, y_m, slip_m, opening_m}}`.
/// `outcome`: `bracketed`, `stands-at-1000`, `falls-at-0.001`, `stopped` or `limit`; null: an end that was not found, the
/// mode where everything is stable, the material of joints without one.
/// \param solved the scene as it was solved: cut.
std::string safetyJson(const Scene& solved, const SafetyFactor& found);

/// What is known of a run in progress.
struct ProgressLine {
    std::string stage;
    double time = 0.0;  // [s] within the stage, or pseudo-time
    double fraction = 0.0;  // of the whole run
    std::optional<double> secondsLeft;  // null: not known yet
    long passes = 0;
    long events = 0;
    std::string search{};  // what a long search for equilibrium does; empty: none is in progress
};

/// `{stage, time_s, fraction, eta_s, passes, events, search}` on one line; `search` is a text or null.
std::string progressJson(const ProgressLine& line);

}  // namespace keyblock::cli
