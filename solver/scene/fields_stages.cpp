// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Field table of stages: their motions, loads, velocities, accelerations and
// strength changes.
#include "solver/scene/automatic.h"
#include "solver/scene/field_rows.h"

namespace keyblock {

namespace {

const Only staticOnly{.key = "kind", .words = {"static"}};
const Only dynamicOnly{.key = "kind", .words = {"dynamic"}};

constexpr std::string_view pointInBlock = translatable("Fields", "Point in block");
constexpr std::string_view unchanged = translatable("Fields", "unchanged");
constexpr std::string_view activationTitle = translatable("Fields", "Excavation and support");

double usualBody(const Scene&) { return automaticBody; }
double usualSmallest(const Scene&) { return automaticSmallest; }
double mostIterations(const Scene& scene) { return scene.limits.iterations.value_or(automaticIterations); }
double rhoInfOf(const Scene& scene) { return scene.analysis.rhoInf; }
FieldValue integrationOf(const Scene& scene) { return rows::toValue(scene.analysis.integration); }
FieldValue timeStepOf(const Scene& scene, const Stage& stage) {
    return stage.duration > 0.0 ? FieldValue(automaticTimeStep(scene, stage)) : FieldValue();
}

// In a static stage, time is pseudo-time and has no unit. Only rows of stages may use this.
bool inStaticStage(const void*, const void* stage) {
    return stage && static_cast<const Stage*>(stage)->kind == StageKind::Static;
}

}  // namespace

const Structure& structureOf(const Motion*) {
    static const Structure structure{
        "motion",
        "Prescribes the displacement of a block's centroid along an axis; the other direction and the strains stay "
        "free. It also applies in later stages until one of them gives the block another motion.",
        defaultsOf<Motion>(),
        {
            row<&Motion::blockAt>("block_at", "A point inside the block; if the block is cut into cells, the cell that "
                                              "contains the point moves.",
                                  {.label = pointInBlock, .unit = "m", .required = true}),
            row<&Motion::axis>("axis", "Direction of the displacement.", {.required = true, .isAxis = true}),
            row<&Motion::table>("table",
                                "Time and displacement since the start of the run or the last `zero_displacements`; "
                                "the time is 0 … 1 in a static stage, seconds in a dynamic one. The last value applies "
                                "afterwards.",
                                {.unit = "s, m", .takesSecond = inStaticStage,
                                 .columns = {{translatable("Fields", "Time"), "s"},
                                             {translatable("Fields", "Displacement"), "m", "m"}},
                                 .required = true}),
            row<&Motion::rotation>("rotation", "Whether the block's rotation is fixed."),
        }};
    return structure;
}

const Structure& structureOf(const Load*) {
    static const Structure structure{
        "load",
        "A force at a block's centroid (`block_at`), at a point of it (`block_at` and `at`, or `point`), or a pressure "
        "on edges (`along`). It keeps its last value in later stages; a load of a later stage at the same location "
        "(the same block, or the same `at`, `point` or `along`) replaces it.",
        defaultsOf<Load>(),
        {
            row<&Load::blockAt>("block_at", "A point inside the loaded block; cells share the force by mass.",
                                {.label = pointInBlock, .unit = "m"}),
            row<&Load::at>("at", "Point of the block at which the force acts, instead of its centroid.",
                           {.unit = "m", .only = {.key = "block_at"}}),
            row<&Load::point>("point", "Point at which the force acts, on the block that contains it.", {.unit = "m"}),
            row<&Load::along>("along", "Pressure acts on the edges of blocks that lie along this line.",
                              {.unit = "m"}),
            row<&Load::force>("force", "Total force over the thickness; it keeps its direction and moves with its "
                                       "point.",
                              {.unit = "N"}),
            row<&Load::pressure>("pressure", "Pressure normal to the edges as they rotate; positive: pushes, negative: "
                                             "pulls.",
                                 {.unit = "Pa", .only = {.key = "along"}}),
            row<&Load::table>("table",
                              "Time and factor; the time is 0 … 1 in a static stage, seconds in a dynamic one. Without "
                              "a table: 1 throughout.",
                              {.unit = "s, –", .takesSecond = inStaticStage,
                               .columns = {{translatable("Fields", "Time"), "s"},
                                           {translatable("Fields", "Factor")}}}),
        }};
    return structure;
}

const Structure& structureOf(const InitialVelocity*) {
    static const Structure structure{
        "initial velocity",
        "Velocity of a block at the start of a dynamic stage.",
        defaultsOf<InitialVelocity>(),
        {
            row<&InitialVelocity::blockAt>("block_at", "A point inside the block.",
                                           {.label = pointInBlock, .unit = "m", .required = true}),
            row<&InitialVelocity::velocity>("velocity", "Velocity of its centroid.", {.unit = "m/s"}),
            row<&InitialVelocity::spin>("spin", "Angular velocity, counter-clockwise.",
                                        {.label = translatable("Fields", "Angular velocity"), .unit = "rad/s"}),
        }};
    return structure;
}

const Structure& structureOf(const Until*) {
    static const Structure structure{
        "until",
        "When a static stage is in equilibrium, and when the search for equilibrium ends without it.",
        defaultsOf<Until>(),
        {
            row<&Until::unbalanced>("unbalanced",
                                    "Unbalanced force divided by the reference force at equilibrium; null: 1e-4, or "
                                    "`tolerance` of the analysis if that is less.",
                                    {.label = translatable("Fields", "Unbalanced force ratio"),
                                     .range = {.least = 0.0, .most = 0.1, .leastExcluded = true},
                                     .automatic = automatic<automaticUnbalanced>}),
            row<&Until::body>("body",
                              "Unbalanced force on a block, or moment divided by its size, relative to its own weight "
                              "at equilibrium (without gravity: relative to its load or to the largest force on it); "
                              "null: 1e-3.",
                              {.label = translatable("Fields", "Unbalanced force ratio of a block"),
                               .range = {.least = 0.0, .most = 0.1, .leastExcluded = true},
                               .automatic = automatic<usualBody>}),
            row<&Until::move>("move",
                              "Largest displacement of a block since the start of the stage, relative to its size "
                              "(from its centroid to its farthest corner) and measured from what it touched or was "
                              "bolted to at the start. If a block comes to rest farther away, the stage ends as "
                              "displaced. Null: no limit.",
                              {.label = translatable("Fields", "Max. movement"), .range = above(0),
                               .nullText = translatable("Fields", "no limit")}),
            row<&Until::smallest>("smallest",
                                  "Blocks smaller than this do not decide stability: one that falls is removed and "
                                  "listed, and the search continues without it; 0: all blocks decide; null: 0.01.",
                                  {.label = translatable("Fields", "Min. block area"), .unit = "m²",
                                   .range = atLeast(0), .automatic = automatic<usualSmallest>}),
            row<&Until::maxSteps>("max_steps",
                                  "Pseudo-steps, repeated ones included, after which the stage ends as undecided, if "
                                  "less than `iterations` of the limits; null: that limit alone.",
                                  {.label = translatable("Fields", "Max. steps"), .range = within(1, 1e9),
                                   .automatic = automatic<mostIterations>}),
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
            row<&Sine::frequency>("frequency", "Cycles per second.",
                                  {.unit = "Hz", .range = above(0), .required = true}),
            row<&Sine::phase>("phase", "Phase at time 0.", {.unit = "rad"}),
        }};
    return structure;
}

const Structure& structureOf(const Acceleration*) {
    static const Structure structure{
        "acceleration",
        "An acceleration: a record (`file`, or `record` in the scene itself) or a `sine` over the seconds of a dynamic "
        "stage, or a constant `value`, the only kind that a static stage accepts. Give exactly one of them.",
        defaultsOf<Acceleration>(),
        {
            row<&Acceleration::file>("file",
                                     "CSV file with the header `time_s,a` and rows of time and value, in the folder of "
                                     "the scene or by a path relative to it.",
                                     {.emptyIsNull = true, .isSentence = true}),
            row<&Acceleration::record>("record",
                                       "The rows of the record, with linear interpolation between them and zero before "
                                       "the first and after the last. If it is given, `file` only names its source; a "
                                       "run store keeps the record in this form.",
                                       {.unit = "s, –", .takesSecond = inStaticStage,
                                        .columns = {{translatable("Fields", "Time"), "s"},
                                                    {translatable("Fields", "Value")}},
                                        .emptyIsNull = true}),
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
        "New strength of a joint material from the start of a stage; values that are null stay unchanged.",
        defaultsOf<StrengthChange>(),
        {
            row<&StrengthChange::jointMaterial>("joint_material", "Name of one of the `joint_materials`.",
                                                {.required = true, .names = {"joint_materials"}}),
            row<&StrengthChange::frictionAngle>(
                "friction_angle", "Friction angle.",
                {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true}, .nullText = unchanged}),
            row<&StrengthChange::residualFrictionAngle>(
                "residual_friction_angle",
                "Friction angle of a contact after its first slip, including contacts that slipped before. At most the "
                "friction angle of this stage.",
                {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true}, .nullText = unchanged}),
            row<&StrengthChange::cohesion>("cohesion", "Cohesion of contacts that have not lost it.",
                                           {.unit = "Pa", .range = atLeast(0), .nullText = unchanged}),
            row<&StrengthChange::tensileStrength>("tensile_strength",
                                                  "Tensile strength of contacts that have not lost it.",
                                                  {.unit = "Pa", .range = atLeast(0), .nullText = unchanged}),
        }};
    return structure;
}

const Structure& structureOf(const Dilation*) {
    static const Structure structure{
        "dilation",
        "A joint whose faces are driven apart: the gap at which its contacts carry no force grows at a given rate "
        "against any resistance.",
        defaultsOf<Dilation>(),
        {
            row<&Dilation::joint>("joint", "Name of a joint or joint set, whose faces open. If none has that name, "
                                   "name of a joint material, of which all contacts open.",
                                  {.required = true, .names = {"joints", "joint_sets", "joint_materials"}}),
            row<&Dilation::rate>("rate", "Rate of opening; in a static stage, the opening over the whole stage.",
                                 {.unit = "m/s, or m", .takesSecond = inStaticStage, .required = true}),
        }};
    return structure;
}

const Structure& structureOf(const Stage*) {
    static const Structure structure{
        "stage",
        "A part of the run: static, over pseudo-time 0 … 1, or dynamic, over seconds.",
        defaultsOf<Stage>(),
        {
            row<&Stage::name>("name", "Name of the stage in tables.", {.required = true}),
            row<&Stage::kind>("kind", "Static or dynamic."),
            row<&Stage::motions>("motions", "Prescribed displacements."),
            row<&Stage::loads>("loads", "Forces and pressures."),
            row<&Stage::dilations>("dilations",
                                   "Joints that open over this stage; openings given for a joint by its own name and "
                                   "by that of its material add up."),
            row<&Stage::set>("set", "Strengths of joints that change at the start of this stage.",
                             {.label = translatable("Fields", "Strength changes")}),
            row<&Stage::excavate>("excavate",
                                  "Names of tunnels and blocks that are excavated at the start of this stage. A tunnel "
                                  "that no stage excavates is open from the start.",
                                  {.names = {"tunnels", "blocks"}, .heading = activationTitle}),
            row<&Stage::install>("install",
                                 "Names of bolts and patterns that are installed at the start of this stage, "
                                 "unstressed in the rock as it is at that time. Bolts that no stage installs are "
                                 "present from the start.",
                                 {.names = {"bolt_patterns", "bolts"}, .heading = activationTitle}),
            row<&Stage::remove>("remove",
                                "Names of bolts and patterns that are removed at the start of this stage.",
                                {.names = {"bolt_patterns", "bolts"}, .heading = activationTitle}),
            row<&Stage::zeroDisplacements>("zero_displacements",
                                           "Whether displacements of blocks, monitors and motions are counted from the "
                                           "start of this stage."),
            row<&Stage::continueAfterCollapse>("continue", "Whether the next stage runs after a collapse of this one.",
                                               {.label = translatable("Fields", "Continue after collapse")}),
            row<&Stage::until>("until", "Criteria of equilibrium.",
                               {.label = translatable("Fields", "Stop criteria"), .only = staticOnly}),
            row<&Stage::increments>("increments",
                                    "Number of equal increments of pseudo-time 0 … 1. Null: chosen by what happens in "
                                    "them; one where no joint slides or opens and no bolt yields or fails, at most a "
                                    "seventh of the stage where joints start or stop sliding or opening, a fiftieth "
                                    "where bolts yield.",
                                    {.range = within(1, 1e6), .only = staticOnly}),
            row<&Stage::relaxation>("relaxation",
                                    "Relaxation: share of the forces of the excavated rock on its walls that is "
                                    "released, at a constant rate, by the end of the stage; the rest keeps acting "
                                    "until a later stage releases it. Null: all of what this stage excavates, at once "
                                    "in a dynamic stage.", {.range = within(0, 1), .heading = activationTitle}),
            row<&Stage::onCollapse>("on_collapse",
                                    "What follows if the stage ends in collapse: the next stage, or first the motion "
                                    "of the falling blocks, as rows of a separate dynamic stage, called by the name of "
                                    "this one and `(collapse)`. It starts at rest where the collapse was found, under "
                                    "the loads that act at that time.",
                                    {.only = staticOnly}),
            row<&Stage::collapseDuration>("collapse_duration", "Duration of that motion.",
                                          {.unit = "s", .range = above(0), .only = staticOnly}),
            row<&Stage::duration>("duration", "Duration of the stage.",
                                  {.unit = "s", .range = atLeast(0), .only = dynamicOnly}),
            row<&Stage::timeStep>("time_step", "Longest time step; null: chosen by the program.",
                                  {.unit = "s", .range = above(0), .only = dynamicOnly,
                                   .automatic = automatic<timeStepOf>}),
            row<&Stage::integration>("integration", "Time integration; null: that of the analysis.",
                                     {.only = dynamicOnly, .automatic = automatic<integrationOf>}),
            row<&Stage::rhoInf>("rho_inf", "Spectral radius of `generalized-alpha` at infinite frequency: the share of "
                                           "very stiff motion that a step keeps; null: that of the analysis.",
                                {.label = translatable("Fields", "ρ∞"), .range = within(0, 1), .only = dynamicOnly,
                                 .automatic = automatic<rhoInfOf>}),
            row<&Stage::initialVelocities>("initial_velocities", "Velocities of blocks at the start of the stage.",
                                           {.only = dynamicOnly}),
            row<&Stage::viscousBoundaries>("viscous_boundaries",
                                           "Sides of the domain, or without a domain of the bounding box of all "
                                           "blocks, that absorb outgoing waves in this stage: `left`, `right`, "
                                           "`bottom`, `top` or `all`. The reactions of point supports there remain as "
                                           "forces.", {.only = dynamicOnly, .words = boundarySideWords}),
            row<&Stage::baseAcceleration>("base_acceleration",
                                          "Acceleration of the ground, which all supports follow. Displacements and "
                                          "velocities are relative to the ground.",
                                          {.only = dynamicOnly}),
            row<&Stage::bodyAcceleration>("body_acceleration",
                                          "Force per mass on everything, in addition to gravity; a ground that "
                                          "accelerates in one direction acts as a body acceleration in the opposite "
                                          "one. In a static stage only a constant `value`; the next static stage "
                                          "without one removes it in proportion to pseudo-time, a dynamic stage starts "
                                          "without it."),
        }};
    return structure;
}

}  // namespace keyblock
