// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Field table of everything other than the model itself: the description of the
// scene, analysis settings, monitors, output and run limits.
#include "solver/scene/automatic.h"
#include "solver/scene/field_rows.h"
#include "solver/scene/preset.h"

namespace keyblock {

namespace {

constexpr std::string_view numerical = translatable("Fields", "Numerical settings");
constexpr std::string_view noLimit = translatable("Fields", "no limit");

double usualIterations(const Scene&) { return automaticIterations; }

/// What a run uses for a setting that the scene leaves to its preset.
template <auto member>
FieldValue ofPreset(const Scene& scene) {
    return rows::toValue(numericsOf(scene.analysis).*member);
}

}  // namespace

const Structure& structureOf(const Expected*) {
    static const Structure structure{
        "expected",
        "An expected result of a run of the scene.",
        defaultsOf<Expected>(),
        {
            row<&Expected::quantity>("quantity", "Quantity, written as in `quantities`.",
                                     {.required = true, .isSentence = true}),
            row<&Expected::value>("value", "Expected value in SI units.", {.required = true}),
            row<&Expected::tolerance>("tolerance", "Relative tolerance; absolute if the value "
                                                   "is 0.", {.range = atLeast(0)}),
            row<&Expected::source>("source", "Source of the number.", {.isSentence = true}),
        }};
    return structure;
}

const Structure& structureOf(const About*) {
    static const Structure structure{
        "about",
        "Description of the scene; it does not affect results.",
        defaultsOf<About>(),
        {
            row<&About::shows>("shows", "What the scene shows.", {.isSentence = true}),
            row<&About::source>("source", "Source of the scene.", {.isSentence = true}),
            row<&About::category>("category", "Heading under which the scene is listed."),
            row<&About::expected>("expected", "Expected results of a run."),
        }};
    return structure;
}

const Structure& structureOf(const Damping*) {
    static const Structure structure{
        "damping",
        "Rayleigh damping of dynamic stages. A free vibration of angular frequency ω has a damping ratio of mass/2ω + "
        "stiffness·ω/2.",
        defaultsOf<Damping>(),
        {
            row<&Damping::mass>("mass", "Damping force on every body divided by its mass and velocity.",
                                {.unit = "1/s", .range = atLeast(0)}),
            row<&Damping::stiffness>("stiffness",
                                     "Damping stress divided by elastic stiffness and strain rate, in blocks and bolt "
                                     "shanks; contacts, supports and anchors have none.",
                                     {.unit = "s", .range = atLeast(0)}),
        }};
    return structure;
}

const Structure& structureOf(const Analysis*) {
    static const Structure structure{
        "analysis",
        "Settings of the whole analysis.",
        defaultsOf<Analysis>(),
        {
            row<&Analysis::plane>("plane", "Plane stress or plane strain."),
            row<&Analysis::thickness>("thickness", "Thickness of the model out of the plane.",
                                      {.unit = "m", .range = within(1e-6, 1e6)}),
            row<&Analysis::gravity>("gravity", "Acceleration that acts on every block and bolt; [] is zero.",
                                    {.unit = "m/s²", .range = within(-1e6, 1e6), .emptyIsZero = true}),
            row<&Analysis::integration>("integration", "Time integration of dynamic stages that give none.",
                                        {.heading = numerical, .isRare = true}),
            row<&Analysis::rhoInf>(
                "rho_inf",
                "Spectral radius of `generalized-alpha` at infinite frequency: the share of very "
                "stiff motion that a step keeps, in stages that give none. 1: nothing is damped, 0: "
                "all of it.",
                {.label = translatable("Fields", "ρ∞"), .range = within(0, 1), .heading = numerical, .isRare = true}),
            row<&Analysis::damping>("damping", "Rayleigh damping of dynamic stages."),
            row<&Analysis::preset>("preset",
                                   "Numerical settings for a purpose. Each of those below that is null, and automatic "
                                   "time steps and divisions, are determined by it.",
                                   {.heading = numerical}),
            row<&Analysis::penaltyRatio>("penalty_ratio",
                                         "Stiffness of a contact spring divided by Young's modulus × thickness.",
                                         {.range = above(0),
                                          .heading = numerical,
                                          .isRare = true,
                                          .automatic = automatic<ofPreset<&Numerics::penaltyRatio>>}),
            row<&Analysis::shearRatio>("shear_ratio", "Shear over normal stiffness of contacts.",
                                       {.range = above(0), .heading = numerical, .isRare = true}),
            row<&Analysis::tolerance>("tolerance",
                                      "Unbalanced force divided by the acting forces at which an "
                                      "iteration is accepted.",
                                      {.range = {.least = 0.0, .most = 0.1, .leastExcluded = true},
                                       .heading = numerical,
                                       .isRare = true,
                                       .automatic = automatic<ofPreset<&Numerics::tolerance>>}),
            row<&Analysis::maxPasses>("max_passes",
                                      "Maximum number of iterations of a step before the time step or "
                                      "increment is reduced.",
                                      {.label = translatable("Fields", "Max. iterations"),
                                       .range = within(1, 100000),
                                       .heading = numerical,
                                       .isRare = true,
                                       .automatic = automatic<ofPreset<&Numerics::maxPasses>>}),
            row<&Analysis::iteration>(
                "iteration",
                "How the states of contacts are found: by minimising the step's convex energy, or "
                "by the classical open–close iteration, for small reference scenes.",
                {.heading = numerical, .isRare = true}),
            row<&Analysis::contact>(
                "contact",
                "How contacts are kept closed: by penalty springs, or by forces that are iterated "
                "in each step until nothing penetrates.",
                {.heading = numerical, .isRare = true, .automatic = automatic<ofPreset<&Numerics::contact>>}),
            row<&Analysis::sleepTolerance>(
                "sleep_tolerance",
                "Unbalanced force on a block, divided by its weight, up to which the block may sleep in dynamic stages: a "
                "block that has come to rest is left out of the steps until the force on it changes by more, and "
                "by more than a step may leave unbalanced. 0: no block sleeps.",
                {.range = {.least = 0.0, .most = 1.0},
                 .heading = numerical,
                 .isRare = true,
                 .automatic = automatic<ofPreset<&Numerics::sleepTolerance>>}),
            row<&Analysis::timeStepFactor>("time_step_factor",
                                           "Factor on the time steps of dynamic stages that give none.",
                                           {.range = within(1e-3, 1e3),
                                            .heading = numerical,
                                            .isRare = true,
                                            .automatic = automatic<ofPreset<&Numerics::timeStepFactor>>}),
            row<&Analysis::divisionsFactor>("divisions_factor",
                                            "Factor on the number of elements of bolts that give no divisions.",
                                            {.range = within(0.01, 100),
                                             .heading = numerical,
                                             .isRare = true,
                                             .automatic = automatic<ofPreset<&Numerics::divisionsFactor>>}),
            row<&Analysis::modelEverything>(
                "model_everything",
                "Whether parts that do not affect the results are modelled as well, such as "
                "sleeping blocks. For comparison; it takes longer.",
                {.heading = numerical, .isRare = true}),
        }};
    return structure;
}

const Structure& structureOf(const Monitor*) {
    static const Only withBolt{.key = "bolt"};
    static const Structure structure{
        "monitor",
        "Records a point (two values: its displacement), an opening between two points, or a bolt. Give exactly one of "
        "`point`, `between` and `bolt`.",
        defaultsOf<Monitor>(),
        {
            row<&Monitor::name>("name", "Name of the monitor in tables and quantities.", {.required = true}),
            row<&Monitor::point>("point", "Point that is followed, in the block that contains it.", {.unit = "m"}),
            row<&Monitor::between>("between", "Displacement of the second point minus that of the first, on `axis`.",
                                   {.unit = "m"}),
            row<&Monitor::axis>("axis", "Direction of the opening.",
                                {.isAxis = true, .only = {.key = "between"}}),
            row<&Monitor::bolt>("bolt", "Name of the bolt.",
                                {.names = {"bolts", "bolt_patterns"}, .namesSingleBolts = true}),
            row<&Monitor::quantity>("quantity",
                                    "Recorded quantity of the bolt; `utilisation` is (N/N_p)² + (Q/Q_p)², "
                                    "`utilisation_with_moment` adds |M|/M_p.",
                                    {.only = withBolt}),
            row<&Monitor::at>("at", "Position along the bolt from its far end.",
                              {.unit = "m", .range = atLeast(0), .only = withBolt}),
            row<&Monitor::atFromHead>("at_from_head", "Position along the bolt from its head.",
                                      {.unit = "m", .range = atLeast(0), .only = withBolt}),
            row<&Monitor::atFraction>("at_fraction", "Position along the bolt, 0 at its far end, 1 at its head.",
                                      {.range = within(0, 1), .only = withBolt}),
        }};
    return structure;
}

const Structure& structureOf(const Safety*) {
    static const Structure structure{
        "safety",
        "How `keyblock safety` finds the factor of safety: the factor by which strengths are divided when the static "
        "stages no longer reach equilibrium. `keyblock run` ignores it.",
        defaultsOf<Safety>(),
        {
            row<&Safety::reduce>("reduce",
                                 "Strengths that are divided: `joints` (tangent of the friction angles, cohesion, "
                                 "tensile strength), `bonds` (strength of the anchors of bolts) or `both`. Intact rock "
                                 "across an outline, steel and face plates keep their strength."),
            row<&Safety::tolerance>("tolerance", "Largest difference between the stable and the failing factor at the "
                                                 "end of the search.",
                                    {.range = within(1e-6, 1)}),
            row<&Safety::boltForces>("bolt_forces",
                                     "Forces of bolts at factors other than 1. `mobilised`: bolts are modelled as in a "
                                     "run, so their forces rise as the rock moves. `frozen`: the forces that bolts "
                                     "exert on the blocks at the end of each stage at a factor of 1 act as dead loads "
                                     "instead."),
        }};
    return structure;
}

const Structure& structureOf(const Output*) {
    static const Structure structure{
        "output",
        "Results that a run saves.",
        defaultsOf<Output>(),
        {
            row<&Output::frames>("frames",
                                 "Frames saved over the whole run, the same number in each stage. Null: at most 200; a "
                                 "static stage whose 'increments' are null has one at the end of each increment. At "
                                 "most as many more are saved just before and just after failures of bolts.",
                                 {.range = within(1, 100000)}),
            row<&Output::every>("every",
                                "Time between frames, instead of 'frames'. A static stage whose 'increments' are null "
                                "has frames and history rows at exactly the pseudo-times that follow from either of "
                                "the two.",
                                {.label = translatable("Fields", "Frame interval"),
                                 .unit = "s, or pseudo-time of a static stage", .range = above(0)}),
        }};
    return structure;
}

const Structure& structureOf(const RunLimits*) {
    static const Structure structure{
        "limits",
        "Limits at which a run ends even if its stages are not finished; the results so far are kept.",
        defaultsOf<RunLimits>(),
        {
            row<&RunLimits::wallTime>("wall_time", "Wall-clock time; null: no limit.",
                                      {.unit = "s", .range = above(0), .nullText = noLimit}),
            row<&RunLimits::steps>("steps", "Accepted steps and equilibria over all stages; null: no limit.",
                                   {.range = within(1, 2e9), .nullText = noLimit}),
            row<&RunLimits::iterations>("iterations",
                                        "Pseudo-steps of a static stage since the last event or accepted increment, "
                                        "after which the stage ends as undecided; null: 20000.",
                                        {.range = within(1, 2e9), .automatic = automatic<usualIterations>}),
            row<&RunLimits::energy>("energy",
                                    "Energy balance error at which a dynamic stage ends as failed, relative to the "
                                    "largest term of the balance.",
                                    {.range = {.least = 0.0, .most = 1.0, .leastExcluded = true}}),
        }};
    return structure;
}

}  // namespace keyblock
