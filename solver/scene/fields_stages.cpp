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
        "free.",
        defaultsOf<Motion>(),
        {
            row<&Motion::blockAt>("block_at", "A point inside the block; of one in cells, the cell there moves.",
                                  {.unit = "m", .required = true}),
            row<&Motion::axis>("axis", "Direction of the displacement.", {.required = true, .isAxis = true}),
            row<&Motion::table>("table",
                                "Time and displacement; the time is 0 … 1 in a static stage, seconds in a dynamic "
                                "one. The last value holds afterwards.",
                                {.unit = "s, m", .required = true}),
            row<&Motion::rotation>("rotation", "Whether the block's rotation is held."),
        }};
    return structure;
}

const Structure& structureOf(const Load*) {
    static const Structure structure{
        "load",
        "A force at a block's centroid (`block_at`), at a point of it (`block_at` and `at`, or `point`), or a pressure "
        "on edges (`along`).",
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
            row<&Until::unbalanced>("unbalanced", "Unbalanced force over reference force at equilibrium.",
                                    {.range = {.least = 0.0, .most = 0.1, .leastExcluded = true}}),
            row<&Until::maxSteps>("max_steps", "Pseudo-steps per equilibrium; null: chosen by the program.",
                                  {.range = within(1, 1e9)}),
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
            row<&Stage::zeroDisplacements>("zero_displacements", "Counts displacements from the start of this stage."),
            row<&Stage::continueAfterCollapse>("continue", "Whether the next stage runs after a collapse of this one."),
            row<&Stage::until>("until", "When equilibrium is found.", {.only = staticOnly}),
            row<&Stage::increments>("increments", "Parts of pseudo-time 0 … 1; null: chosen by the program.",
                                    {.range = within(1, 1e6), .only = staticOnly}),
            row<&Stage::duration>("duration", "How long the stage lasts.",
                                  {.unit = "s", .range = atLeast(0), .only = dynamicOnly}),
            row<&Stage::timeStep>("time_step", "Longest step; null: chosen by the program.",
                                  {.unit = "s", .range = above(0), .only = dynamicOnly}),
            row<&Stage::integration>("integration", "Time integration; null: that of the analysis.",
                                     {.only = dynamicOnly, .laterWords = {"newmark", "generalized-alpha"}}),
            row<&Stage::initialVelocities>("initial_velocities", "Velocities of blocks at the start of the stage.",
                                           {.only = dynamicOnly}),
        }};
    return structure;
}

}  // namespace keyblock
