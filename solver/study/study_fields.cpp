// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/study_fields.h"

#include "solver/scene/field_rows.h"

namespace keyblock {

const Structure& structureOf(const StudyPlan*) {
    static const Only drawn{.key = "kind", .words = {"latin-hypercube", "monte-carlo"}};
    static const Structure structure{
        "plan",
        "How the cases are chosen.",
        defaultsOf<StudyPlan>(),
        {
            row<&StudyPlan::kind>("kind",
                                  "`full-factorial`: every combination of the values of lists and ranges. "
                                  "`latin-hypercube`: each distribution is divided into as many parts of equal "
                                  "probability as there are cases, and each part is used once. `monte-carlo`: "
                                  "independent draws; a case keeps its values when the number of cases is changed."),
            row<&StudyPlan::cases>("cases", "Number of cases.", {.range = within(1, mostCases), .only = drawn}),
            row<&StudyPlan::seed>(
                "seed",
                "Random seed. The draws of a case depend only on it, on the number of the case and on "
                "the names of parameters and faults.",
                {.range = within(0, 2147483647)}),
            row<&StudyPlan::casesPerTask>("cases_per_task",
                                          "Cases that one task of a job array runs, one after the other; null: as many "
                                          "as are needed for at most 1000 tasks.",
                                          {.range = within(1, mostCases)}),
        }};
    return structure;
}

const Structure& structureOf(const StudyRange*) {
    static const Structure structure{
        "value range",
        "Equally spaced values, both ends included; each is equally probable.",
        defaultsOf<StudyRange>(),
        {
            row<&StudyRange::from>("from", "First value.", {.required = true}),
            row<&StudyRange::to>("to", "Last value.", {.required = true}),
            row<&StudyRange::count>("count", "Number of values.", {.range = within(2, mostCases), .required = true}),
        }};
    return structure;
}

const Structure& structureOf(const StudyDistribution*) {
    static const Only bounded{.key = "kind", .words = {"uniform", "triangular", "normal", "lognormal"}};
    static const Only triangular{.key = "kind", .words = {"triangular"}};
    static const Only normal{.key = "kind", .words = {"normal", "lognormal"}};
    static const Structure structure{
        "distribution",
        "A probability distribution.",
        defaultsOf<StudyDistribution>(),
        {
            row<&StudyDistribution::kind>(
                "kind",
                "`uniform`: between `least` and `most`. `triangular`: between `least` and `most`, most likely at `peak`. "
                "`normal`, `lognormal`: with `mean` and `deviation`, truncated at `least` and `most` where these are "
                "given. `seed`: another whole number in each case, for the seeds of joint sets and Voronoi cells.",
                {.required = true}),
            row<&StudyDistribution::mean>("mean", "Mean, before the distribution is truncated.", {.only = normal}),
            row<&StudyDistribution::deviation>("deviation", "Standard deviation, before the distribution is truncated.",
                                               {.range = above(0), .only = normal}),
            row<&StudyDistribution::least>("least", "Smallest value.", {.only = bounded}),
            row<&StudyDistribution::most>("most", "Largest value.", {.only = bounded}),
            row<&StudyDistribution::peak>("peak", "Most likely value.", {.only = triangular}),
        }};
    return structure;
}

const Structure& structureOf(const StudyParameter*) {
    static const Structure structure{
        "parameter",
        "A value of the scene that varies from case to case. Give exactly one of `values`, `range` and `distribution`.",
        defaultsOf<StudyParameter>(),
        {
            row<&StudyParameter::name>("name", "Name of the parameter: its column in tables. Empty: the path."),
            row<&StudyParameter::path>("path",
                                       "Path of the value in the scene, as for `--set`; items of lists by number or by "
                                       "name: `stages[0].increments`, `bolts.B1.pretension`.",
                                       {.required = true}),
            row<&StudyParameter::also>("also", "Paths of further values that get the same value; seeds differ."),
            row<&StudyParameter::values>("values",
                                         "List of values: numbers, texts, true or false; each is equally "
                                         "probable."),
            row<&StudyParameter::range>("range", "Equally spaced values."),
            row<&StudyParameter::distribution>("distribution", "A probability distribution."),
        }};
    return structure;
}

const Structure& structureOf(const StudyFault*) {
    static const Only ofBond{.key = "kind", .words = {"bond-lost"}};
    static const Only ofPlace{.key = "kind", .words = {"misplaced"}};
    static const Structure structure{
        "fault",
        "A fault of installation. Each bolt has it or not, independently of the others.",
        defaultsOf<StudyFault>(),
        {
            row<&StudyFault::name>("name", "Name of the fault: its column in tables.", {.required = true}),
            row<&StudyFault::kind>("kind",
                                   "`missing`: the bolt is not there. `bond-lost`: a part of its length has no bond. "
                                   "`misplaced`: it lies off its position, at another angle.",
                                   {.required = true}),
            row<&StudyFault::bolts>("bolts", "Bolts and bolt patterns that may have the fault; empty: all."),
            row<&StudyFault::probability>("probability", "Probability that a bolt has the fault.",
                                          {.range = within(0, 1)}),
            row<&StudyFault::share>("share", "Least and most share of the length without bond; uniform between them.",
                                    {.range = within(0, 1), .only = ofBond}),
            row<&StudyFault::where>("where", "Where the part without bond lies.", {.only = ofBond}),
            row<&StudyFault::offsetDeviation>(
                "offset_deviation",
                "Standard deviation of the offset of the whole bolt, along the wall at its "
                "head; at most three times as much.",
                {.unit = "m", .range = atLeast(0), .only = ofPlace}),
            row<&StudyFault::angleDeviation>("angle_deviation",
                                             "Standard deviation of its angle; at most three times as much.",
                                             {.unit = "°", .range = within(0, 25), .only = ofPlace}),
        }};
    return structure;
}

const Structure& studyStructure() {
    static const Structure structure{
        "study",
        "One study per file: a scene that is run many times with different values.",
        defaultsOf<Study>(),
        {
            fixedRow("format", "File type.", {std::string("keyblock-study")}, true),
            fixedRow("version", "Version of the format.", {1.0}, true),
            row<&Study::title>("title", "Title of the study.", {.isSentence = true}),
            row<&Study::scene>("scene", "Path of the scene, relative to the study file.", {.required = true}),
            row<&Study::plan>("plan", "How the cases are chosen."),
            row<&Study::parameters>("parameters", "Values of the scene that vary."),
            row<&Study::faults>("faults", "Faults in the installation of bolts."),
            row<&Study::quantities>("quantities",
                                    "Results of interest, as in the `quantities` of a scene; empty: those of the "
                                    "scene. `factor_of_safety` needs `safety`.",
                                    {.isSentence = true}),
            row<&Study::fails>("fails",
                               "What counts as failure of a case: `QUANTITY > NUMBER` (or `>=`, `<`, `<=`), `stands`, "
                               "`lost bolt` (a bolt ruptured or lost), each with `not` before it or without, joined by "
                               "`and` and `or`; `and` binds closer. Empty: none.",
                               {.isSentence = true}),
            row<&Study::safety>("safety",
                                "Whether the factor of safety of each case is found, by the `safety` settings of "
                                "the scene."),
            row<&Study::keep>(
                "keep",
                "Run stores of finished cases that are kept: `all`, `thin` (with the first and last frame "
                "of each stage) or `none`."),
        }};
    return structure;
}

}  // namespace keyblock
