// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of what happens: stages, motions, loads, velocities.
#include "solver/scene/field_rows.h"

namespace keyblock {

namespace {

const Only staticOnly{.key = "kind", .words = {"static"}};
const Only dynamicOnly{.key = "kind", .words = {"dynamic"}};

}  // namespace

const Structure& structureOf(const Motion*) {
    static const Structure structure{
        "motion",
        "Prescribes the displacement of a block's centroid along an axis; the other direction and the strains stay "
        "free. It holds in later stages, until one of them gives the block another motion.",
        defaultsOf<Motion>(),
        {
            row<&Motion::blockAt>("block_at", "A point inside the block; of one in cells, the cell there moves.",
                                  {.unit = "m", .required = true}),
            row<&Motion::axis>("axis", "Direction of the displacement.", {.required = true, .isAxis = true}),
            row<&Motion::table>("table",
                                "Time and displacement since the start of the run or the last `zero_displacements`; "
                                "the time is 0 … 1 in a static stage, seconds in a dynamic one. The last value holds "
                                "afterwards.",
                                {.unit = "s, m", .required = true}),
            row<&Motion::rotation>("rotation", "Whether the block's rotation is held."),
        }};
    return structure;
}

const Structure& structureOf(const Load*) {
    static const Structure structure{
        "load",
        "A force at a block's centroid (`block_at`), at a point of it (`block_at` and `at`, or `point`), or a pressure "
        "on edges (`along`). It stays with its last value in later stages; a load of a later stage at the same place "
        "(the same block, or the same `at`, `point` or `along`) takes its place.",
        defaultsOf<Load>(),
        {
            row<&Load::blockAt>("block_at", "A point inside the loaded block; cells share the force by mass.",
                                {.unit = "m"}),
            row<&Load::at>("at", "Where the force acts on the block, in place of its centroid.",
                           {.unit = "m", .only = {.key = "block_at"}}),
            row<&Load::point>("point", "Where the force acts, on the block that holds the point.", {.unit = "m"}),
            row<&Load::along>("along", "Pressure acts on the edges of blocks that lie along this line.",
                              {.unit = "m"}),
            row<&Load::force>("force", "Total over the thickness; keeps its direction and follows its point.",
                              {.unit = "N"}),
            row<&Load::pressure>("pressure", "Normal to the edges as they turn; positive presses, negative pulls.",
                                 {.unit = "Pa", .only = {.key = "along"}}),
            row<&Load::table>("table",
                              "Time and factor; the time is 0 … 1 in a static stage, seconds in a dynamic one. "
                              "Missing: 1 throughout.",
                              {.unit = "s, –"}),
        }};
    return structure;
}

const Structure& structureOf(const InitialVelocity*) {
    static const Structure structure{
        "initial velocity",
        "Velocity of a block at the start of a dynamic stage.",
        defaultsOf<InitialVelocity>(),
        {
            row<&InitialVelocity::blockAt>("block_at", "A point inside the block.", {.unit = "m", .required = true}),
            row<&InitialVelocity::velocity>("velocity", "Velocity of its centroid.", {.unit = "m/s"}),
            row<&InitialVelocity::spin>("spin", "Angular velocity, counter-clockwise.", {.unit = "rad/s"}),
        }};
    return structure;
}

const Structure& structureOf(const Until*) {
    static const Structure structure{
        "until",
        "When a static stage is at equilibrium, and when it gives up looking for it.",
        defaultsOf<Until>(),
        {
            row<&Until::unbalanced>("unbalanced",
                                    "Unbalanced force over reference force at equilibrium; null: 1e-4, or `tolerance` "
                                    "of the analysis where that is less.",
                                    {.range = {.least = 0.0, .most = 0.1, .leastExcluded = true}}),
            row<&Until::body>("body",
                              "Unbalanced force on a block, or moment over its size, over its own weight at equilibrium "
                              "(without gravity over its load, or the largest force on it); null: 1e-3.",
                              {.range = {.least = 0.0, .most = 0.1, .leastExcluded = true}}),
            row<&Until::move>("move",
                              "How far a block may have gone since the stage began, over its size (from its centroid "
                              "to its farthest corner), seen from what it touched or was bolted to then. What comes to "
                              "rest farther away ends the stage as displaced. Null: any way.",
                              {.range = above(0)}),
            row<&Until::smallest>("smallest",
                                  "Blocks of less area do not decide: one that falls is removed and listed, and the "
                                  "search continues without it; 0: all decide; null: 0.01.",
                                  {.unit = "m²", .range = atLeast(0)}),
            row<&Until::maxSteps>("max_steps",
                                  "Pseudo-steps, repeated ones included, after which the stage ends as undecided, if "
                                  "less than `iterations` of the limits; null: those alone.",
                                  {.range = within(1, 1e9)}),
        }};
    return structure;
}

const Structure& structureOf(const Sine*) {
    static const Structure structure{
        "sine",
        "amplitude · sin(2π · frequency · time + phase).",
        defaultsOf<Sine>(),
        {
            row<&Sine::amplitude>("amplitude", "Largest value, before the factor.", {.unit = "m/s²", .required = true}),
            row<&Sine::frequency>("frequency", "Cycles a second.",
                                  {.unit = "Hz", .range = above(0), .required = true}),
            row<&Sine::phase>("phase", "Phase at time 0.", {.unit = "rad"}),
        }};
    return structure;
}

const Structure& structureOf(const Acceleration*) {
    static const Structure structure{
        "acceleration",
        "An acceleration: a record (`file`, or `record` in the scene itself) or a `sine` over the seconds of a dynamic "
        "stage, or a constant `value`, the only one that a static stage takes. Exactly one of them is given.",
        defaultsOf<Acceleration>(),
        {
            row<&Acceleration::file>("file",
                                     "CSV file with the header `time_s,a` and rows of time and value, beside the scene "
                                     "or by a path relative to it.",
                                     {.emptyIsNull = true}),
            row<&Acceleration::record>("record",
                                       "The rows themselves: straight lines between them, nothing before the first "
                                       "and after the last. Where it is given, `file` only says where it came from; a "
                                       "run store keeps the record so.",
                                       {.unit = "s, –", .emptyIsNull = true}),
            row<&Acceleration::sine>("sine", "A harmonic acceleration instead of a record."),
            row<&Acceleration::value>("value",
                                      "A constant acceleration instead of a record. A static stage changes to it in "
                                      "proportion to pseudo-time, from what acted when the stage began: a seismic "
                                      "coefficient k is `\"value\": k` with a factor of 9.81.",
                                      {.unit = "m/s²"}),
            row<&Acceleration::axis>("axis", "Direction of a positive acceleration.",
                                     {.required = true, .isAxis = true}),
            row<&Acceleration::factor>("factor", "Multiplies the record, the sine or the value; 9.81 for numbers in g.",
                                       {.unit = "m/s² per unit"}),
        }};
    return structure;
}

const Structure& structureOf(const StrengthChange*) {
    static const Structure structure{
        "strength change",
        "New strength of a joint material from the start of a stage on; what is null stays as it is.",
        defaultsOf<StrengthChange>(),
        {
            row<&StrengthChange::jointMaterial>("joint_material", "Which of the `joint_materials`.",
                                                {.required = true}),
            row<&StrengthChange::frictionAngle>(
                "friction_angle", "Friction angle.",
                {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true}}),
            row<&StrengthChange::residualFrictionAngle>(
                "residual_friction_angle",
                "Friction angle of a contact after its first slip, of those that slipped before, too. At most the "
                "friction angle of this stage.",
                {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true}}),
            row<&StrengthChange::cohesion>("cohesion", "Cohesion of contacts that have not lost it.",
                                           {.unit = "Pa", .range = atLeast(0)}),
            row<&StrengthChange::tensileStrength>("tensile_strength",
                                                  "Tensile strength of contacts that have not lost it.",
                                                  {.unit = "Pa", .range = atLeast(0)}),
        }};
    return structure;
}

const Structure& structureOf(const Dilation*) {
    static const Structure structure{
        "dilation",
        "A joint whose faces are driven apart: the gap at which its contacts carry nothing grows at a rate, whatever "
        "resists it.",
        defaultsOf<Dilation>(),
        {
            row<&Dilation::joint>("joint", "Name of a joint or a joint set: what it parts opens. Where none has that "
                                   "name, of a joint material: all its contacts open.", {.required = true}),
            row<&Dilation::rate>("rate", "How fast it opens; over a whole static stage, how far.",
                                 {.unit = "m/s, or m", .required = true}),
        }};
    return structure;
}

const Structure& structureOf(const Stage*) {
    static const Structure structure{
        "stage",
        "A part of the run: static, over pseudo-time 0 … 1, or dynamic, over seconds.",
        defaultsOf<Stage>(),
        {
            row<&Stage::name>("name", "Names the stage in tables.", {.required = true}),
            row<&Stage::kind>("kind", "Static or dynamic."),
            row<&Stage::motions>("motions", "Prescribed displacements."),
            row<&Stage::loads>("loads", "Forces and pressures."),
            row<&Stage::dilations>("dilations",
                                   "Joints that open over this stage; what a joint opens by its own name and by that "
                                   "of its material adds up."),
            row<&Stage::set>("set", "Strengths of joints that change at the start of this stage."),
            row<&Stage::excavate>("excavate",
                                  "Names of tunnels, and of blocks, that are taken out at the start of this stage. A "
                                  "tunnel that no stage excavates is open from the start."),
            row<&Stage::install>("install",
                                 "Names of bolts and patterns that are installed at the start of this stage, unstressed "
                                 "in the rock as it is then. What no stage installs is there from the start."),
            row<&Stage::remove>("remove",
                                "Names of bolts and patterns that are taken away at the start of this stage."),
            row<&Stage::zeroDisplacements>("zero_displacements",
                                           "Counts displacements of blocks, monitors and motions from the start of "
                                           "this stage."),
            row<&Stage::continueAfterCollapse>("continue", "Whether the next stage runs after a collapse of this one."),
            row<&Stage::until>("until", "When equilibrium is found.", {.only = staticOnly}),
            row<&Stage::increments>("increments",
                                    "Equal parts of pseudo-time 0 … 1. Null: chosen by what happens in them; one where "
                                    "no joint slides or opens and no bolt flows or fails, a tenth of the stage at most "
                                    "where joints begin or stop to slide or open, a fiftieth where bolts flow.",
                                    {.range = within(1, 1e6), .only = staticOnly}),
            row<&Stage::relaxation>("relaxation",
                                    "Share of the forces that excavated rock gave to its walls which is released "
                                    "evenly by the end of the stage; the rest is held by later stages until one of "
                                    "them releases it. Null: all of what this stage excavates, at once in a dynamic "
                                    "stage.",
                                    {.range = within(0, 1)}),
            row<&Stage::onCollapse>("on_collapse",
                                    "What follows where the stage ends as a collapse: the next stage, or first the "
                                    "motion of the falling blocks, as rows of a dynamic stage of its own, called by "
                                    "the name of this one and `(collapse)`. It begins at rest where the collapse was "
                                    "found, under the loads of then.",
                                    {.only = staticOnly}),
            row<&Stage::collapseDuration>("collapse_duration", "How long that motion lasts.",
                                          {.unit = "s", .range = above(0), .only = staticOnly}),
            row<&Stage::duration>("duration", "How long the stage lasts.",
                                  {.unit = "s", .range = atLeast(0), .only = dynamicOnly}),
            row<&Stage::timeStep>("time_step", "Longest step; null: chosen by the program.",
                                  {.unit = "s", .range = above(0), .only = dynamicOnly}),
            row<&Stage::integration>("integration", "Time integration; null: that of the analysis.",
                                     {.only = dynamicOnly}),
            row<&Stage::rhoInf>("rho_inf", "Share of very stiff motion that a step of `generalized-alpha` keeps; "
                                           "null: that of the analysis.",
                                {.range = within(0, 1), .only = dynamicOnly}),
            row<&Stage::initialVelocities>("initial_velocities", "Velocities of blocks at the start of the stage.",
                                           {.only = dynamicOnly}),
            row<&Stage::viscousBoundaries>("viscous_boundaries",
                                           "Sides of the domain, or where there is none of the box round all blocks, "
                                           "that let waves out in this stage: `left`, `right`, `bottom`, `top` or "
                                           "`all`. What held points gave there stays as a force.",
                                           {.only = dynamicOnly}),
            row<&Stage::baseAcceleration>("base_acceleration",
                                          "Acceleration of the ground, which all that is held follows. Displacements "
                                          "and velocities are told relative to the ground.",
                                          {.only = dynamicOnly}),
            row<&Stage::bodyAcceleration>("body_acceleration",
                                          "Force per mass on everything, in addition to gravity; a ground that "
                                          "accelerates in one direction acts as a body acceleration in the opposite one. In "
                                          "a static stage a constant `value` only; the next static stage without one removes "
                                          "it in proportion to pseudo-time, a dynamic stage starts without it."),
        }};
    return structure;
}

}  // namespace keyblock
