// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only file that uses CLI11, because CLI11 is slow to compile.
#include "app/cli/command_line.h"

#include "app/cli/figure_words.h"
#include "app/cli/output.h"
#include "solver/engine/step/blas_kernel.h"
#include "solver/files/program_version.h"
#include "solver/results/tables.h"
#include "solver/scene/enum_names.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace keyblock::cli {

namespace {

constexpr int mostThreads = 1024;

const std::map<std::string, ProgressKind> progressKinds{
    {"bar", ProgressKind::Bar}, {"json", ProgressKind::Json}, {"none", ProgressKind::None}};

std::string progressProblem(const std::string& word) {
    return progressKinds.contains(word) ? "" : "'" + word + "' is not one of bar, json, none";
}

/// `nan` and `inf` pass CLI11's ranges.
std::string finiteProblem(const std::string& word) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    return end != word.c_str() && *end == '\0' && !std::isfinite(number) ? "'" + word + "' is not a finite number" : "";
}

/// One member for each command, filled while CLI11 parses.
struct Options {
    RunOptions run;
    CheckOptions check;
    InfoOptions info;
    ExportOptions exported;
    ImportOptions imported;
    SafetyOptions safety;
    TradeOptions trade;
    CompareOptions compare;
    ReportOptions report;
    SweepPlanOptions sweepPlan;
    SweepRunOptions sweepRun;
    SweepStatusOptions sweepStatus;
    SweepCollectOptions sweepCollect;
    StressOptions stress;
    VerifyOptions verify;
    BoltsOptions bolts;
};

std::string presetNames() {
    std::string names;
    for (const std::string_view word : presetWords) names += (names.empty() ? "" : "|") + std::string(word);
    return names;
}

std::string presetProblem(const std::string& word) {
    const bool known = std::find(presetWords.begin(), presetWords.end(), word) != presetWords.end();
    return known ? "" : "'" + word + "' is not one of " + presetNames();
}

/// Adds --set and --preset, which stands for the first --set: it replaces the preset of the scene, and settings that are
/// given stay.
void addOverrides(CLI::App* verb, std::vector<std::string>& overrides) {
    verb->add_option("--set", overrides, "Replace values of the scene before it is read; may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false)
        ->take_all();
    verb->add_option_function<std::string>(
            "--preset",
            [&overrides](const std::string& word) { overrides.insert(overrides.begin(), "analysis.preset=" + word); },
            "Numerical settings for a purpose, instead of the scene's preset; values that the scene gives or --set "
            "replaces stay")
        ->type_name(presetNames())
        ->check(presetProblem);
}

template <typename VerbOptions>
void addProgress(CLI::App* verb, VerbOptions& options) {
    verb->add_option_function<std::string>(
            "--progress", [&options](const std::string& word) { options.progress = progressKinds.at(word); },
            "Format of the progress on standard error; json: one object per line; default: bar on a terminal, "
            "otherwise none")
        ->type_name("bar|json|none")
        ->check(progressProblem);
}

/// Adds the options of commands that run scenes.
template <typename VerbOptions>
void addThreadsAndProgress(CLI::App* verb, VerbOptions& options) {
    verb->add_option("--threads", options.threads,
                     "Number of threads; does not affect results; default: all that the machine has")
        ->type_name("N")
        ->check(CLI::Range(1, mostThreads).description(""));
    addProgress(verb, options);
}

void addRun(CLI::App& app, RunOptions& options) {
    CLI::App* verb = app.add_subcommand("run", "Run a scene and save the results in a run store");
    verb->add_option("SCENE.json", options.scene, "The scene")->required()->type_name("");
    verb->add_option("--out", options.out, "The run store; default: the scene's name with .kbrun, in the same folder")
        ->type_name("RUN.kbrun");
    addOverrides(verb, options.overrides);
    addThreadsAndProgress(verb, options);
    CLI::Option* resume = verb->add_flag("--resume", options.resume,
                                         "Resume an interrupted run; if there is none, start from the beginning");
    verb->add_flag("--overwrite", options.overwrite, "Replace an existing run store")->excludes(resume);
    verb->add_flag("--fail-on-collapse", options.failOnCollapse, "Exit with code 8 if the scene is not stable");
    verb->add_flag(
        "--estimate-error", options.estimateError,
        "Run again with half the time step and with twice the divisions of the most loaded bolt, and estimate "
        "the error of each quantity of interest");
}

void addCheck(CLI::App& app, CheckOptions& options) {
    CLI::App* verb = app.add_subcommand("check",
                                        "Check a scene: errors with fixes, the model summary, and an estimate "
                                        "of run time and memory; no results are written");
    verb->add_option("SCENE.json", options.scene, "The scene, or a study, which is checked with its scene")
        ->required()
        ->type_name("");
    addOverrides(verb, options.overrides);
    verb->add_flag("--all", options.all, "List all changes made when the domain was cut, not only ten of each kind");
    verb->add_flag("--json", options.json, "Print the answer in JSON");
}

void addInfo(CLI::App& app, InfoOptions& options) {
    CLI::App* verb = app.add_subcommand("info", "Show the contents of a run store, finished or not");
    verb->add_option("RUN.kbrun", options.run, "The run store")->required()->type_name("");
    verb->add_flag("--json", options.json, "Print the answer in JSON");
}

std::string tableNames() {
    std::string names;
    for (const std::string_view word : tableWords())
        names += (names.empty() ? "" : "|") + std::string(word);
    return names;
}

std::string figureNames() {
    std::string names;
    for (const std::string_view word : figureWords())
        names += (names.empty() ? "" : "|") + std::string(word);
    return names;
}

void addFigureOptions(CLI::App* verb, ExportOptions& options) {
    verb->add_option("--quantity", options.quantity, "Quantity that a figure or animation shows; an unknown name lists "
                                                     "the valid ones")
        ->type_name("NAME");
    verb->add_option("--width", options.width, "Width of a figure or animation; default 160")
        ->type_name("MM")
        ->check(finiteProblem)
        ->check(CLI::Range(60.0, 500.0).description(""));
    verb->add_option("--dpi", options.dpi, "Resolution of a PNG, default 300, or of an animation, default 240")
        ->type_name("N")
        ->check(CLI::Range(50, 1200).description(""));
    verb->add_option("--deformed", options.deformed, "Factor by which displacements are exaggerated")
        ->type_name("FACTOR")
        ->check(finiteProblem)
        ->check(CLI::Range(0.0, 1e6).description(""));
    verb->add_flag("--whole", options.whole, "Show the whole model, not only the surroundings of tunnels and bolts");
}

void addExport(CLI::App& app, ExportOptions& options) {
    CLI::App* verb = app.add_subcommand("export", "Write a table of a run as CSV, a figure for a report, an animation, or the "
                                                  "run for ParaView");
    verb->add_option("RUN.kbrun", options.run, "The run store")->required()->type_name("");
    CLI::Option* table = verb->add_option("--table", options.table, "Table to write")->type_name(tableNames());
    CLI::Option* figure = verb->add_option("--figure", options.figure, "Figure to draw; its data are written next to "
                                                                       "it as CSV")
                              ->type_name(figureNames())
                              ->excludes(table);
    CLI::Option* vtk =
        verb->add_option("--vtk", options.vtk,
                         "Write time series of blocks, bolts and contacts (PVD, VTP) into this folder instead of a "
                         "table")
            ->type_name("DIR")
            ->excludes(figure);
    verb->add_option("--animation", options.animation,
                     "Write all frames as an animation (ffmpeg) or PNG images, with fixed colour ranges")
        ->type_name("FILE.(mp4|webm)|DIR")
        ->excludes(table)
        ->excludes(figure)
        ->excludes(vtk);
    verb->add_option("--fps", options.perSecond, "Frames per second of an animation; default 12")
        ->type_name("N")
        ->check(CLI::Range(1, 120).description(""));
    verb->add_option("--bolt", options.bolt,
                     "Only this bolt (tables events, bolts and design); in a section, the bolt whose "
                     "force diagram is drawn")
        ->type_name("NAME");
    verb->add_option("--stage", options.stage, "Only this stage")->type_name("NAME");
    verb->add_option("--at", options.at,
                     "Time to export: the nearest one saved, the last one or all; default: last for bolts, blocks, "
                     "contacts, forces, design and figures, all for the others")
        ->type_name("STAGE:TIME|last|all");
    addFigureOptions(verb, options);
    verb->add_option("--reference", options.references,
                     "A measured or published curve to add to figure curves: CSV with a header such as "
                     "opening_mm,load_kN; may be repeated")
        ->type_name("FILE.csv")
        ->allow_extra_args(false)
        ->take_all();
    verb->add_option("--out", options.out, "The file to write; for a figure, its extension selects the format")
        ->type_name("FILE.(csv|svg|pdf|png)");
    verb->add_flag("--overwrite", options.overwrite,
                   "Also replace existing CSV files next to a figure that are not its data; a file named with --out "
                   "is always replaced, unless it is a run store or a scene");
}

/// Reads `LAYER=role`; the name of the layer may contain `=`.
std::string addRole(const std::string& text, ImportSettings& settings) {
    const auto sign = text.rfind('=');
    const auto role = sign == std::string::npos ? std::nullopt : layerRoleOf(text.substr(sign + 1));
    if (!role || sign == 0)
        return "'" + text + "' is not of the form LAYER=joint|boundary|tunnel|bolt|ignore";
    settings.roles.emplace_back(text.substr(0, sign), *role);
    return "";
}

void addImport(CLI::App& app, ImportOptions& options) {
    CLI::App* verb =
        app.add_subcommand("import", "Create a scene from a drawing (DXF) or from a list of joints or bolts (CSV)");
    verb->add_option("FILE.(dxf|csv)", options.file, "The drawing or list")->required()->type_name("");
    verb->add_option_function<std::vector<std::string>>(
            "--role",
            [&options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    if (const std::string problem = addRole(text, options.settings); !problem.empty())
                        throw CLI::ValidationError("--role", problem);
            },
            "Role of a layer whose name does not show it; '*=ROLE' for all other layers; may be repeated")
        ->type_name("LAYER=joint|boundary|tunnel|bolt|ignore")
        ->allow_extra_args(false)
        ->take_all();
    verb->add_option_function<std::string>(
            "--units",
            [&options](const std::string& word) {
                options.settings.unit = lengthUnitOf(word);
                if (!options.settings.unit)
                    throw CLI::ValidationError("--units", "'" + word + "' is not one of " + lengthUnitWords());
            },
            "Units of the coordinates; default: those given in the file")
        ->type_name("m|mm|cm|ft|...");
    verb->add_option("--sagitta", options.settings.sagitta,
                     "Largest distance between arcs or splines and their straight segments; default: 5e-4 of the "
                     "drawing's size")
        ->type_name("METRES")
        ->check(finiteProblem)
        ->check(CLI::PositiveNumber.description(""));
    verb->add_flag("--all", options.all, "List every entity that was skipped, not only ten of each kind");
    verb->add_option("--out", options.out, "The scene to write")->required()->type_name("SCENE.json");
    verb->add_flag("--overwrite", options.overwrite, "Replace an existing scene");
}

void addSafety(CLI::App& app, SafetyOptions& options) {
    CLI::App* verb = app.add_subcommand("safety", "Find the factor of safety of a static scene by strength reduction");
    verb->add_option("SCENE.json", options.scene, "The scene; its 'safety' sets what is reduced and how closely the "
                                                  "factor is bracketed")
        ->required()
        ->type_name("");
    verb->add_option("--out", options.out, "The folder for the runs nearest the bracket and the table of all runs; "
                                           "default: the scene's name with -safety, in the same folder")
        ->type_name("DIR");
    verb->add_flag("--overwrite", options.overwrite, "Replace the folder of an earlier search");
    addOverrides(verb, options.overrides);
    addThreadsAndProgress(verb, options);
    verb->add_flag("--json", options.json, "Print the answer in JSON");
}

void addTrade(CLI::App& app, TradeOptions& options) {
    CLI::App* verb = app.add_subcommand("trade",
                                        "Measure what the numerical settings of a scene cost and what they "
                                        "change, and recommend some");
    verb->add_option("SCENE.json", options.scene,
                     "The scene; its 'quantities' are compared, or some that are chosen from "
                     "its results")
        ->required()
        ->type_name("");
    verb->add_option("--out", options.out,
                     "The folder for the table, the page and the chart; an interrupted trade "
                     "continues there")
        ->required()
        ->type_name("DIR");
    verb->add_option("--budget", options.budget, "Leave out runs that would exceed this time for all runs together")
        ->type_name("SECONDS")
        ->check(CLI::PositiveNumber.description(""));
    addOverrides(verb, options.overrides);
    addProgress(verb, options);
}

void addCompare(CLI::App& app, CompareOptions& options) {
    CLI::App* verb = app.add_subcommand("compare",
                                        "Compare two runs of the same rock: blocks that fall in one and are "
                                        "stable in the other, the bolts that hold them, and the "
                                        "differences of displacements and forces");
    verb->add_option("A.kbrun", options.a, "A run store")->required()->type_name("");
    verb->add_option("B.kbrun", options.b, "The run store to compare it with")->required()->type_name("");
    verb->add_flag("--json", options.json, "Print the answer in JSON");
}

void addReport(CLI::App& app, ReportOptions& options) {
    CLI::App* verb = app.add_subcommand("report",
                                        "Write a report of a run: model, stages, bolts, events with their "
                                        "causes, curves and solver diagnostics; or of a sweep");
    verb->add_option("RUN.kbrun|DIR", options.run, "The run store, or the folder of a collected sweep")
        ->required()
        ->type_name("");
    verb->add_option("--out", options.out, "The file to write; its extension selects the format")
        ->required()
        ->type_name("FILE.(pdf|html)");
    verb->add_option("--template", options.layout, "A text file that chooses and orders the sections and names a logo")
        ->type_name("FILE");
    verb->add_option("--project", options.project, "Name of the project, for the title block")->type_name("TEXT");
    verb->add_option("--author", options.author, "Name of the author, for the title block")->type_name("TEXT");
    verb->add_option("--date", options.date, "Date of the report, for the title block")->type_name("TEXT");
    verb->add_flag("--overwrite", options.overwrite, "Replace an existing report");
}

void addSweepRun(CLI::App* sweep, SweepRunOptions& options) {
    CLI::App* verb = sweep->add_subcommand("run",
                                           "Run cases of a sweep; finished cases are skipped, interrupted ones "
                                           "resumed");
    verb->add_option("DIR", options.sweep, "The folder of the sweep")->required()->type_name("");
    verb->add_option("--index", options.index,
                     "The cases, counted from 1; default: those of the task in the environment variable "
                     "SLURM_ARRAY_TASK_ID")
        ->type_name("N[-M]");
    verb->add_option("--threads", options.threads, "Number of threads; does not affect results; default: 1")
        ->type_name("N")
        ->check(CLI::Range(1, mostThreads).description(""));
}

void addSweep(CLI::App& app, Options& options) {
    CLI::App* sweep = app.add_subcommand("sweep", "Run a scene many times with different values, as a study file says");
    sweep->require_subcommand(1);
    CLI::App* plan = sweep->add_subcommand("plan",
                                           "Make the folder of a sweep: its cases, the frozen scene and study, "
                                           "and scripts for Slurm and GNU parallel");
    plan->add_option("STUDY.json", options.sweepPlan.study, "The study")->required()->type_name("");
    plan->add_option("--out", options.sweepPlan.out, "The folder, new or empty")->required()->type_name("DIR");
    addSweepRun(sweep, options.sweepRun);
    CLI::App* status = sweep->add_subcommand("status", "Show how many cases are finished, running and waiting");
    status->add_option("DIR", options.sweepStatus.sweep, "The folder of the sweep")->required()->type_name("");
    status->add_flag("--json", options.sweepStatus.json, "Print the answer in JSON");
    CLI::App* collect = sweep->add_subcommand("collect", "Write the results of all cases with statistics and figures");
    collect->add_option("DIR", options.sweepCollect.sweep, "The folder of the sweep")->required()->type_name("");
    collect
        ->add_option("--scatter", options.sweepCollect.scatter,
                     "A further scatter plot of two columns of results.csv; may be repeated")
        ->type_name("X,Y")
        ->allow_extra_args(false)
        ->take_all();
}

void addStress(CLI::App& app, StressOptions& options) {
    CLI::App* verb = app.add_subcommand("stress",
                                        "Push a scene along its settings and report what breaks first, how far "
                                        "the answer moved, and what to set");
    verb->add_option("SCENE.json", options.scene,
                     "The scene; its 'quantities' are compared, or some that are chosen from its results")
        ->required()
        ->type_name("");
    addOverrides(verb, options.overrides);
    addProgress(verb, options);
    verb->add_flag("--json", options.json, "Print the answer in JSON");
}

void addVerify(CLI::App& app, VerifyOptions& options) {
    CLI::App* verb = app.add_subcommand("verify", "Check the program against independent reference values");
    CLI::Option* names = verb->add_option("--case", options.names, "Only this case; may be repeated")
                             ->type_name("NAME")
                             ->allow_extra_args(false);
    verb->add_flag("--paper", options.paper,
                   "Print the paper's tables: values of the paper, the reference and Keyblock")
        ->excludes(names);
    CLI::Option* extremes = verb->add_flag("--extremes", options.extremes,
                                           "Run scenes with known answers to and past the limits of the method; --case "
                                           "then names a case, a scene or an axis")
                                ->excludes("--paper");
    CLI::Option* random = verb->add_option("--random", options.random,
                                           "Run this many random combinations of extremes; without --page or --case, "
                                           "only these")
                              ->type_name("N")
                              ->check(CLI::Range(1, 1000000).description(""))
                              ->needs(extremes);
    verb->add_option("--seed", options.seed, "Seed of the random combinations; default 1")
        ->type_name("S")
        ->needs(random);
    verb->add_option("--page", options.page, "Write the help page of the limits to this file")
        ->type_name("FILE.md")
        ->needs(extremes);
    verb->add_flag("--json", options.json, "Print the answer in JSON");
}

void addBolts(CLI::App& app, BoltsOptions& options) {
    CLI::App* verb = app.add_subcommand("bolts", "List the bolt library, or one type with the source of every number");
    verb->add_option("NAME", options.name, "A bolt type of the library")->type_name("");
}

void requireKnownVerb(const CLI::App& app, int argc, const char* const* argv) {
    if (argc > 1 && argv[1][0] == '-')
        return;
    std::string names;
    for (const CLI::App* verb : app.get_subcommands({})) {
        if (argc > 1 && verb->get_name() == argv[1])
            return;
        names += (names.empty() ? "" : ", ") + verb->get_name();
    }
    const std::string fault =
        argc > 1 ? "there is no command '" + std::string(argv[1]) + "'" : "the command is missing";
    throw UsageError(fault + "; there are " + names + "; see 'keyblock --help'");
}

/// Reports the first line of CLI11's message, followed by our own hint.
[[noreturn]] void fail(const CLI::App& app, const CLI::ParseError& error) {
    std::string message = error.what();
    message = message.substr(0, message.find('\n'));
    std::string verb;
    for (const CLI::App* chosen : app.get_subcommands())
        verb = " " + chosen->get_name();
    throw UsageError(message + "; see 'keyblock" + verb + " --help'");
}

/// `--set a=1 b=2` means `--set a=1 --set b=2`: further words are values as long as they contain `=`.
std::vector<std::string> wordsInReverse(int argc, const char* const* argv) {
    std::vector<std::string> words;
    bool setting = false;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool option = word.rfind('-', 0) == 0;
        const bool another = setting && !option && words.back() != "--set" && word.find('=') != std::string::npos;
        if (another)
            words.push_back("--set");
        setting = another || word == "--set" || (setting && words.back() == "--set");
        words.push_back(word);
    }
    std::reverse(words.begin(), words.end());
    return words;
}

Command sweepCommandOf(const CLI::App& sweep, const Options& options) {
    const std::string verb = sweep.get_subcommands().front()->get_name();
    if (verb == "plan") return options.sweepPlan;
    if (verb == "run") return options.sweepRun;
    if (verb == "status") return options.sweepStatus;
    return options.sweepCollect;
}

Command commandOf(const CLI::App& app, const Options& options) {
    const std::string verb = app.get_subcommands().front()->get_name();
    if (verb == "run")
        return options.run;
    if (verb == "check")
        return options.check;
    if (verb == "info")
        return options.info;
    if (verb == "export")
        return options.exported;
    if (verb == "import")
        return options.imported;
    if (verb == "safety")
        return options.safety;
    if (verb == "trade") return options.trade;
    if (verb == "compare") return options.compare;
    if (verb == "report") return options.report;
    if (verb == "sweep") return sweepCommandOf(*app.get_subcommands().front(), options);
    if (verb == "stress") return options.stress;
    if (verb == "verify")
        return options.verify;
    return options.bolts;
}

}  // namespace

std::variant<Command, Answer> readCommandLine(int argc, const char* const* argv) {
    Options options;
    CLI::App app("Keyblock: discontinuous deformation analysis of blocky rock and of rock bolts up to their failure",
                 "keyblock");
    const std::string version = "keyblock " + std::string(programVersion()) + "\nOpenBLAS kernel " + blasKernel();
    app.set_version_flag("--version", version, "Print the version and the kernel of the dense algebra");
    app.set_help_flag("--help,-h", "Print this help");
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 1 a verification failed, 2 usage, 3 invalid scene or file, 4 numerical failure,\n"
        "5 limit reached, 6 cannot write, 8 not stable (only with --fail-on-collapse), 70 internal,\n"
        "75 interrupted (run, safety, stress, sweeps and animations, which keep their results; a signal ends other commands at once).");
    addRun(app, options.run);
    addCheck(app, options.check);
    addInfo(app, options.info);
    addExport(app, options.exported);
    addImport(app, options.imported);
    addSafety(app, options.safety);
    addTrade(app, options.trade);
    addCompare(app, options.compare);
    addReport(app, options.report);
    addSweep(app, options);
    addStress(app, options.stress);
    addVerify(app, options.verify);
    addBolts(app, options.bolts);
    requireKnownVerb(app, argc, argv);
    try {
        app.parse(wordsInReverse(argc, argv));
    } catch (const CLI::CallForHelp&) {
        return Answer{app.help()};
    } catch (const CLI::CallForVersion&) {
        return Answer{version + "\n"};
    } catch (const CLI::ParseError& error) {
        fail(app, error);
    }
    return commandOf(app, options);
}

}  // namespace keyblock::cli
