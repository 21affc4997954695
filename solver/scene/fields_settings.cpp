// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of what surrounds the model: what the scene says about itself, settings
// of the analysis, what is watched and what is kept.
#include "solver/scene/field_rows.h"

namespace keyblock {

const Structure& structureOf(const Expected*) {
    static const Structure structure{
        "expected",
        "A number that a run of the scene should give.",
        defaultsOf<Expected>(),
        {
            row<&Expected::quantity>("quantity", "Which number, written as in `quantities`.", {.required = true}),
            row<&Expected::value>("value", "The number, in SI units.", {.required = true}),
            row<&Expected::tolerance>("tolerance", "Relative; absolute where the value is 0.", {.range = atLeast(0)}),
            row<&Expected::source>("source", "Where the number comes from."),
        }};
    return structure;
}

const Structure& structureOf(const About*) {
    static const Structure structure{
        "about",
        "For people: it changes no result.",
        defaultsOf<About>(),
        {
            row<&About::shows>("shows", "What the scene shows."),
            row<&About::source>("source", "Where the scene comes from."),
            row<&About::category>("category", "Under which heading it is listed."),
            row<&About::expected>("expected", "Numbers that a run should give."),
        }};
    return structure;
}

const Structure& structureOf(const Damping*) {
    static const Structure structure{
        "damping",
        "Rayleigh damping of dynamic stages. A free vibration of frequency ω loses the share mass/2ω + stiffness·ω/2 "
        "of critical damping.",
        defaultsOf<Damping>(),
        {
            row<&Damping::mass>("mass", "Force on every body over its mass and velocity.",
                                {.unit = "1/s", .range = atLeast(0)}),
            row<&Damping::stiffness>("stiffness",
                                     "Stress over elastic stiffness and rate of strain, in blocks and in bolts' "
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
            row<&Analysis::integration>("integration", "Time integration of dynamic stages that name none."),
            row<&Analysis::rhoInf>("rho_inf",
                                   "Share of very stiff motion that a step of `generalized-alpha` keeps, in stages "
                                   "that give none: 1 loses nothing, 0 all of it.",
                                   {.range = within(0, 1)}),
            row<&Analysis::damping>("damping", "Rayleigh damping of dynamic stages."),
            row<&Analysis::penaltyRatio>("penalty_ratio",
                                         "Stiffness of a contact spring over Young's modulus × thickness.",
                                         {.range = above(0)}),
            row<&Analysis::shearRatio>("shear_ratio", "Shear over normal stiffness of contacts.",
                                       {.range = above(0)}),
            row<&Analysis::tolerance>("tolerance", "Unbalanced force over the forces at play at which a pass is accepted.",
                                      {.range = {.least = 0.0, .most = 0.1, .leastExcluded = true}}),
            row<&Analysis::maxPasses>("max_passes", "Passes of one step before it is cut.",
                                      {.range = within(1, 100000)}),
            row<&Analysis::iteration>("iteration",
                                      "How the states of contacts are found: by minimising the step's convex energy, or "
                                      "by the classical open–close iteration, for small reference scenes."),
            row<&Analysis::contact>("contact",
                                    "How contacts are kept closed: by penalty springs, or by forces sought in each "
                                    "step until nothing penetrates."),
            fixedRow("model_everything", "Whether parts that change nothing are modelled too.", {false}),
        }};
    return structure;
}

const Structure& structureOf(const Monitor*) {
    static const Only withBolt{.key = "bolt"};
    static const Structure structure{
        "monitor",
        "Watches a point (two values: its displacement), an opening between two points, or a bolt: exactly one of "
        "`point`, `between` and `bolt` is given.",
        defaultsOf<Monitor>(),
        {
            row<&Monitor::name>("name", "Names the monitor in tables and quantities.", {.required = true}),
            row<&Monitor::point>("point", "Follows this point of the block that holds it.", {.unit = "m"}),
            row<&Monitor::between>("between", "Displacement of the second point minus that of the first, on `axis`.",
                                   {.unit = "m"}),
            row<&Monitor::axis>("axis", "Direction of the opening.",
                                {.isAxis = true, .only = {.key = "between"}}),
            row<&Monitor::bolt>("bolt", "Name of the bolt."),
            row<&Monitor::quantity>("quantity",
                                    "What is watched of the bolt; `utilisation` is (N/N_p)² + (Q/Q_p)², "
                                    "`utilisation_with_moment` adds |M|/M_p.",
                                    {.only = withBolt}),
            row<&Monitor::at>("at", "Place along the bolt from its far end.",
                              {.unit = "m", .range = atLeast(0), .only = withBolt}),
            row<&Monitor::atFromHead>("at_from_head", "Place along the bolt from its head.",
                                      {.unit = "m", .range = atLeast(0), .only = withBolt}),
            row<&Monitor::atFraction>("at_fraction", "Place along the bolt, 0 at its far end, 1 at its head.",
                                      {.range = within(0, 1), .only = withBolt}),
        }};
    return structure;
}

const Structure& structureOf(const Safety*) {
    static const Structure structure{
        "safety",
        "How `keyblock safety` looks for the factor of safety: the factor by which strengths are divided when the static "
        "stages no longer find equilibrium. `keyblock run` does not read it.",
        defaultsOf<Safety>(),
        {
            row<&Safety::reduce>("reduce",
                                 "What is divided: `joints` (tan of the friction angles, cohesion, tensile strength), "
                                 "`bonds` (strength of the anchors of bolts) or `both`. Rock that only an outline "
                                 "parts, steel and face plates keep theirs."),
            row<&Safety::tolerance>("tolerance", "Between the factor that stands and the one that does not.",
                                    {.range = within(1e-6, 1)}),
            row<&Safety::boltForces>("bolt_forces",
                                     "What bolts do at other factors than 1. `mobilised`: they are modelled as in a run, "
                                     "so their forces rise as the rock moves. `frozen`: the forces that they put on the "
                                     "blocks at the end of each stage at a factor of 1 act as dead loads in their place."),
        }};
    return structure;
}

const Structure& structureOf(const Output*) {
    static const Structure structure{
        "output",
        "What a run keeps.",
        defaultsOf<Output>(),
        {
            row<&Output::frames>("frames",
                                 "Frames kept over the whole run, as many in each stage. Null: 200 at most; a static "
                                 "stage whose 'increments' are null has one at the end of each increment. At most as "
                                 "many again are kept just before and just after failures of bolts.",
                                 {.range = within(1, 100000)}),
            row<&Output::every>("every",
                                "Time between frames, in place of 'frames'. A static stage whose 'increments' are null "
                                "has frames and history rows at exactly the pseudo-times that either asks for.",
                                {.unit = "s, or pseudo-time of a static stage", .range = above(0)}),
        }};
    return structure;
}

const Structure& structureOf(const RunLimits*) {
    static const Structure structure{
        "limits",
        "Where a run ends even if its stages do not; what it has found by then is kept.",
        defaultsOf<RunLimits>(),
        {
            row<&RunLimits::wallTime>("wall_time", "Time by the clock on the wall; null: no limit.",
                                      {.unit = "s", .range = above(0)}),
            row<&RunLimits::steps>("steps", "Accepted steps and equilibria over all stages; null: no limit.",
                                   {.range = within(1, 2e9)}),
            row<&RunLimits::iterations>("iterations",
                                        "Pseudo-steps of a static stage since the last event or accepted increment, "
                                        "after which the stage ends as undecided; null: 20000.",
                                        {.range = within(1, 2e9)}),
            row<&RunLimits::energy>("energy",
                                    "Energy balance error at which a dynamic stage ends as failed, over the largest "
                                    "term of the balance.",
                                    {.range = {.least = 0.0, .most = 1.0, .leastExcluded = true}}),
        }};
    return structure;
}

}  // namespace keyblock
