// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Field table of the section: the domain and everything that cuts it into
// blocks.
#include "geometry/shape/joint_set.h"
#include "solver/scene/automatic.h"
#include "solver/scene/field_rows.h"
#include "solver/scene/scene_cut.h"

namespace keyblock {

namespace {

constexpr int largestSeed = 2147483647;
constexpr std::string_view tracesTitle = translatable("Fields", "Traces");
constexpr std::string_view wholeDomain = translatable("Fields", "whole domain");

template <double SceneCut::*limit>
FieldValue ofCut(const Scene&, const SceneCut* cut, const void*) {
    return cut ? FieldValue(cut->*limit) : FieldValue();
}

}  // namespace

const Structure& structureOf(const SceneDomain*) {
    static const Structure structure{
        "domain",
        "A region that is cut into blocks. Without joints it is one block.",
        defaultsOf<SceneDomain>(),
        {
            row<&SceneDomain::boundary>("boundary", "Corners, clockwise or counter-clockwise, the first not repeated.",
                                        {.unit = "m", .required = true}),
            row<&SceneDomain::material>("material", "Name of its material.",
                                        {.required = true, .names = {"materials"}}),
            row<&SceneDomain::jointMaterial>("joint_material",
                                             "Name of the joint material of its boundary, and of joints that name "
                                             "none; null: the first of `joint_materials`.",
                                             {.names = {"joint_materials"},
                                              .automatic = automatic<automaticJointMaterial>}),
        }};
    return structure;
}

const Structure& structureOf(const Cutting*) {
    static const Structure structure{
        "cutting",
        "Limits of the cut. `keyblock check` lists the limits used and everything that was merged, trimmed or dropped.",
        defaultsOf<Cutting>(),
        {
            row<&Cutting::tolerance>("tolerance",
                                     "Points and lines closer than this are joined; null: 1e-6 of the longer side of "
                                     "the domain.",
                                     {.unit = "m", .range = above(0), .automatic = ofCut<&SceneCut::tolerance>}),
            row<&Cutting::minArea>("min_area",
                                   "Smaller blocks are merged with a neighbour; null: 1e-3 of the mean area of all "
                                   "blocks; 0: none are merged.",
                                   {.label = translatable("Fields", "Min. area"), .unit = "m²", .range = atLeast(0),
                                    .automatic = ofCut<&SceneCut::minArea>}),
            row<&Cutting::minWidth>("min_width",
                                    "Narrower blocks (2·area / perimeter) are merged with a neighbour; null: 1e-2 of "
                                    "the square root of the mean area, at least ten tolerances; 0: none are merged.",
                                    {.label = translatable("Fields", "Min. width"), .unit = "m", .range = atLeast(0),
                                     .automatic = ofCut<&SceneCut::minWidth>}),
        }};
    return structure;
}

const Structure& structureOf(const SceneJoint*) {
    static const Structure structure{
        "joint",
        "One joint along a line of points.",
        defaultsOf<SceneJoint>(),
        {
            row<&SceneJoint::name>("name", "Name of the joint.", {.required = true}),
            row<&SceneJoint::points>("points", "Points of the line, two or more.", {.unit = "m", .required = true}),
            row<&SceneJoint::jointMaterial>("joint_material",
                                            "Name of the joint material of its faces; null: the domain's.",
                                            {.names = {"joint_materials"},
                                             .automatic = automatic<automaticTraceMaterial>}),
        }};
    return structure;
}

const Structure& structureOf(const SceneJointSet*) {
    static const Only withLength{.key = "trace_length"};
    static const Structure structure{
        "joint set",
        "Parallel lines of traces with rock bridges between them; spacings, trace lengths and bridges are log-normally "
        "distributed, the dip normally.",
        defaultsOf<SceneJointSet>(),
        {
            row<&SceneJointSet::name>("name", "Name of the joint set.", {.required = true}),
            row<&SceneJointSet::dip>("dip", "Apparent dip in the section, counter-clockwise from +x.",
                                     {.unit = "°", .range = within(-360, 360), .required = true}),
            row<&SceneJointSet::dipDeviation>("dip_deviation", "Standard deviation of the dip from trace to trace.",
                                              {.unit = "°", .range = within(0, largestDipDeviation)}),
            row<&SceneJointSet::spacing>("spacing", "Mean distance between lines, normal to them.",
                                         {.unit = "m", .range = above(0), .required = true}),
            row<&SceneJointSet::spacingDeviation>("spacing_deviation", "Standard deviation of the spacing.",
                                                  {.unit = "m", .range = atLeast(0)}),
            row<&SceneJointSet::traceLength>("trace_length", "Mean length of a trace; null: through-going.",
                                             {.unit = "m", .range = above(0), .heading = tracesTitle,
                                              .nullText = translatable("Fields", "through-going")}),
            row<&SceneJointSet::traceLengthDeviation>("trace_length_deviation", "Standard deviation of the trace length.",
                                                      {.label = translatable("Fields", "Length deviation"),
                                                       .unit = "m", .range = atLeast(0), .only = withLength,
                                                       .heading = tracesTitle}),
            row<&SceneJointSet::bridge>("bridge", "Mean length of the rock bridge between two traces of a line.",
                                        {.unit = "m", .range = atLeast(0), .only = withLength, .heading = tracesTitle}),
            row<&SceneJointSet::bridgeDeviation>("bridge_deviation", "Standard deviation of the bridge.",
                                                 {.unit = "m", .range = atLeast(0), .only = withLength,
                                                  .heading = tracesTitle}),
            row<&SceneJointSet::stagger>("stagger",
                                         "Offset of each line from the previous one, as a share of trace length plus "
                                         "bridge; null: random.",
                                         {.only = withLength, .heading = tracesTitle,
                                          .nullText = translatable("Fields", "random")}),
            row<&SceneJointSet::origin>("origin", "Centre of the first trace.", {.unit = "m"}),
            row<&SceneJointSet::seed>("seed", "Random seed.",
                                      {.range = within(0, largestSeed)}),
            row<&SceneJointSet::jointMaterial>("joint_material",
                                               "Name of the joint material of its faces; null: the domain's.",
                                               {.names = {"joint_materials"},
                                                .automatic = automatic<automaticTraceMaterial>}),
            row<&SceneJointSet::region>("region", "Name of the region that it is confined to; null: none.",
                                        {.names = {"regions"}, .nullText = wholeDomain}),
        }};
    return structure;
}

const Structure& structureOf(const SceneRegion*) {
    static const Structure structure{
        "region",
        "A part of the section. It does not cut the rock by itself.",
        defaultsOf<SceneRegion>(),
        {
            row<&SceneRegion::name>("name", "Name of the region.", {.required = true}),
            row<&SceneRegion::points>("points", "Corners, clockwise or counter-clockwise, the first not repeated.",
                                      {.unit = "m", .required = true}),
        }};
    return structure;
}

const Structure& structureOf(const SceneVoronoi*) {
    static const Structure structure{
        "voronoi",
        "Convex cells of about equal size without a preferred direction. The outline of their region is a joint as "
        "well.",
        defaultsOf<SceneVoronoi>(),
        {
            row<&SceneVoronoi::size>("size", "Size of a cell: the mean area is about the square of it.",
                                     {.unit = "m", .range = above(0), .required = true}),
            row<&SceneVoronoi::seed>("seed", "Random seed of the cell positions.", {.range = within(0, largestSeed)}),
            row<&SceneVoronoi::region>("region", "Name of the region that they fill; null: the whole domain.",
                                       {.names = {"regions"}, .nullText = wholeDomain}),
            row<&SceneVoronoi::jointMaterial>("joint_material",
                                              "Name of the joint material of their faces; null: the domain's.",
                                              {.names = {"joint_materials"},
                                               .automatic = automatic<automaticTraceMaterial>}),
        }};
    return structure;
}

const Structure& structureOf(const SceneTunnel*) {
    static const Only round{.key = "profile", .words = {"circle"}};
    static const Only wide{.key = "profile", .words = {"d-shape", "horseshoe", "arched"}};
    static const Only high{.key = "profile", .words = {"d-shape", "horseshoe"}};
    static const Only arched{.key = "profile", .words = {"arched"}};
    static const Only drawn{.key = "profile", .words = {"polygon"}};
    static const Only centred{.key = "profile", .words = {"circle", "d-shape", "horseshoe", "arched"}};
    static const Structure structure{
        "tunnel",
        "An opening in the domain. Where only its outline separates rock, the two sides are bonded as intact rock; a "
        "tunnel that no stage excavates is open from the start.",
        defaultsOf<SceneTunnel>(),
        {
            row<&SceneTunnel::name>("name", "Name of the tunnel.", {.required = true}),
            row<&SceneTunnel::profile>("profile",
                                       "A circle; a semicircle on straight walls; three arcs on a flat floor; a segment "
                                       "of a circle on straight walls; or a polygon.",
                                       {.required = true}),
            row<&SceneTunnel::center>("center", "Centre of the bounding box.", {.unit = "m", .only = centred}),
            row<&SceneTunnel::diameter>("diameter", "Diameter.", {.unit = "m", .range = atLeast(0), .only = round}),
            row<&SceneTunnel::width>("width", "Width.", {.unit = "m", .range = atLeast(0), .only = wide}),
            row<&SceneTunnel::height>("height", "Height, floor to crown.",
                                      {.unit = "m", .range = atLeast(0), .only = high}),
            row<&SceneTunnel::wallHeight>("wall_height", "Height of the straight walls.",
                                          {.unit = "m", .range = atLeast(0), .only = arched}),
            row<&SceneTunnel::rise>("rise", "Rise of the arch above its chord.",
                                    {.unit = "m", .range = atLeast(0), .only = arched}),
            row<&SceneTunnel::points>("points", "Corners, clockwise or "
                                                "counter-clockwise.", {.unit = "m", .only = drawn}),
        }};
    return structure;
}

}  // namespace keyblock
