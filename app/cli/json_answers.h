// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON output with fixed keys for scripts. Keys may be added in later versions, but
// none is removed.
#pragma once

#include "solver/files/run_store/run_store.h"
#include "solver/files/scene/scene_file.h"
#include "solver/results/quantity_estimate.h"
#include "solver/results/run_comparison.h"
#include "solver/run/model_summary.h"
#include "solver/run/safety.h"
#include "solver/scene/problem.h"
#include "solver/trade/stress.h"
#include "solver/verify/extremes/extremes.h"
#include "solver/verify/verify.h"

#include <optional>
#include <span>
#include <string>

namespace keyblock::cli {

/// Output of `check`: `problems[] {severity, pointer, line, message, remedy}`, where `line` is null if it is unknown.
/// If the scene has a domain that was cut, also `cut {blocks, vertices, edges, area_m2, tolerance_m, min_area_m2,
/// min_width_m, open_blocks, splits, reports[] {kind, x_m, y_m, message}}`. If the scene has no errors, also `census
/// {blocks, cells, plates, fixed, contacts, bolts, nodes, unknowns {blocks, plates, bolts}, left_out[] {what, why,
/// saves}, next[] {setting, what, costs, saves, set, measured}, estimate {seconds, seconds_least, seconds_most, memory_MB, pass_seconds, step_seconds, stages[] {name,
/// steps, passes, least, most}, assumes[]}}`. `preset {name, text, settings[] {key, value, from}}`, where `from` is
/// `preset`, `scene` or `--set`, of a scene without errors.
std::string checkJson(const SceneReading& reading, const std::optional<ModelSummary>& summary,
                      std::span<const std::string> overrides);

/// Output of `check` for a study: `problems[]` as above, and `cases`, null if there are errors.
std::string studyCheckJson(std::span<const Problem> problems, std::optional<long> cases);

/// Output of `info`: `title, program_version, scene_hash, stages[] {name, kind, outcome, time_s, steps}, frames,
/// events {kind: count}, chains[][] {event, kind, cause, …}, bolts[] {bolt, axial_N, shear_N, moment_Nm, axial_at_m,
/// stage, time_s, use {steel, shear, bond, plate}, governs, holds[]}, health {…}, verdict {stands, blocks[] {block,
/// mode, moved_m, weight_N}, joints[] {block_a, block_b, mode, slip_m, opening_m}, bolts[] {bolt, event, stage,
/// time_s}}, worst_balance {block, ratio, force_N, stage}, warnings[] {stage, message}, loose[]`. Values that are
/// unknown because a stage has not ended are null. Forces are per bolt; each is the value of largest magnitude over
/// the run, with its sign. `use` is the utilisation of each strength (1: fully used), or null if the bolt does not
/// have that strength.
///
/// `quantities[] {quantity, value, order[], problem}` are those of the scene. `preset` is the preset with the number of settings that were changed. `estimated_errors {refinements[], quantities[]
/// {quantity, value, error, remark}}` is null unless `run --estimate-error` was used.
std::string infoJson(const RunStore& store, const std::optional<ErrorEstimate>& estimate);

/// Output of `compare`: `a {title, scene_hash, stands, unstable[], settled[]}, b {…}, blocks {shared, only_a, only_b},
/// saved[] {block, block_b, falls_in, mode, stage, moved_m, weight_N, held_by[] {bolt, force_N, on}}, displacements[]
/// {block, ux_a_m, uy_a_m, ux_b_m, uy_b_m, difference_m}, bolts[] {bolt, a {axial_N, shear_N, moment_Nm, use, governs},
/// b {…}, axial_difference_N}`. `unstable` are the blocks of the verdict, `settled` those of them that came to rest near
/// their positions. `falls_in` is `a` or `b`; `moved_m` is the displacement over that run; `held_by` lists bolts of the
/// other run, and `on` is the block on which the bolt acts, named as in that run. `a` or `b` of a bolt is null if the
/// bolt is not in that run.
std::string compareJson(const RunStore& a, const RunStore& b, const RunComparison& found);
/// Output of `stress`: `quantities[], own {seconds, values[], failure}, pushes[] {axis, push, physical, ending, change,
/// quantity, reason, warnings[], remedy, seconds}, breaks_first, answer, interrupted`. `ending` is `same`, `moved`,
/// `refused`, `stopped` or `verdict` (the scene becomes unstable or stable); `change` is null if a quantity has no number
/// to compare; `breaks_first` is an index of `pushes`, or null.
std::string stressJson(const StressTest& stress);

/// Output of `verify`: `cases[] {name, quantity, measured, expected, tolerance, relative, passed, seconds}`.
std::string casesJson(std::span<const CaseResult> results);

/// Output of `verify --paper`: `tables[] {title, rows[] {quantity, unit, paper, reference, keyblock, tolerance,
/// passed}}`.
std::string paperJson(std::span<const PaperTable> tables);

/// Output of `verify --extremes`: `cases[] {name, scene, axis, property, runs[] {value, ending, quantity, measured,
/// expected, tolerance, reason, seconds}}, random[] {seed, runs[] {…}}, counts {right, refused, stopped, warned, wrong,
/// median_s, longest_s}`. `quantity` is the one that deviates most for its tolerance; `ending` is a key of `counts`.
std::string extremesJson(std::span<const ExtremeCaseRuns> cases, std::span<const RandomExtremes> random);

/// Output of `safety`: `reduce, bolt_forces, tolerance, factor {lower, upper}, answer, lower, upper, outcome, blocks[],
/// runs[] {factor, stands, stage, outcome, steps, message}, mode {blocks[] {name, movement, displacement_m,
/// rotation_rad}, joints[] {blocks, joint_material, x_m, y_m, slip_m, opening_m}}`. `outcome` is `bracketed`,
/// `stands-at-1000`, `falls-at-0.001`, `fails-at-1` (unstable at full strength, so there are no bolt forces to freeze),
/// `stopped`, `limit` or `undecided`. `lower` or `upper` is null if it was not found, `mode` is null if no run was
/// unstable, and `joint_material` is null if the joint has no material. \param solved the scene as solved, i.e. cut
/// into blocks.
std::string safetyJson(const Scene& solved, const SafetyFactor& found);

/// State of a run in progress, for display.
struct ProgressLine {
    std::string stage;
    double time = 0.0;  // [s] within the stage, or pseudo-time
    double fraction = 0.0;  // completed fraction of the whole run
    std::optional<double> secondsLeft;  // null: not known yet
    long passes = 0;  // iterations
    long events = 0;
    std::string search{};  // description of a long search for equilibrium; empty if none is in progress
};

/// Progress as `{stage, time_s, fraction, eta_s, passes, events, search}` on one line; `search` is a string or null.
std::string progressJson(const ProgressLine& line);

}  // namespace keyblock::cli
