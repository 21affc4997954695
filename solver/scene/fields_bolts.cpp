// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of bolts, their types, anchors and plates.
#include "geometry/bolt_pattern.h"
#include "solver/scene/field_rows.h"

namespace keyblock {

namespace {

constexpr std::string_view boltPaper = "unified rock bolt model in DDA";
constexpr std::string_view usualSteel = "usual for steel";

}  // namespace

const Structure& structureOf(const Anchor*) {
    static const Only noCurve{.key = "law", .words = {"elastic", "peak-residual", "frictional"}};
    static const Only limited{.key = "law", .words = {"peak-residual", "frictional"}};
    static const Only curved{.key = "law", .words = {"curve"}};
    static const Structure structure{
        "anchor",
        "Makes nodes of a bolt real anchors: the node nearest to `at`, or those from `from` to `to`. Later entries "
        "override earlier ones; nodes in no entry are artificial, held across the bolt and free along it.",
        defaultsOf<Anchor>(),
        {
            row<&Anchor::at>("at", "Place along the bolt from its far end; `head`: its head.",
                             {.unit = "m", .range = atLeast(0)}),
            row<&Anchor::from>("from", "Start of the range, from the far end.", {.unit = "m", .range = atLeast(0)}),
            row<&Anchor::to>("to", "End of the range, from the far end.", {.unit = "m", .range = atLeast(0)}),
            row<&Anchor::per>("per",
                              "Whether numbers hold for each node or for each metre of embedded bolt; those of an "
                              "`at` entry hold for its node."),
            row<&Anchor::law>("law",
                              "Elastic without limit; peak, then residual; friction at constant strength; or a "
                              "force–slip curve.",
                              {.required = true}),
            row<&Anchor::stiffness>("stiffness", "Tangential stiffness.",
                                    {.unit = "N/m, or N/m per m", .range = atLeast(0), .only = noCurve}),
            row<&Anchor::strength>("strength", "Force at which the anchor lets go.",
                                   {.unit = "N, or N/m", .range = above(0), .only = limited}),
            row<&Anchor::residual>("residual", "Friction that is left after letting go.",
                                   {.unit = "N, or N/m", .range = atLeast(0),
                                    .only = {.key = "law", .words = {"peak-residual"}}}),
            row<&Anchor::softeningSlip>("softening_slip",
                                        "Slip from the peak to the residual, linear; 0: brittle. Fracture energy "
                                        "per metre: ½·(strength − residual)·(slip + (strength − residual)/stiffness).",
                                        {.unit = "m", .range = atLeast(0),
                                         .only = {.key = "law", .words = {"peak-residual"}}}),
            row<&Anchor::restick>("restick",
                                  "Whether the anchor sticks again when its sliding stops; else it keeps the force "
                                  "it had after letting go.",
                                  {.only = limited}),
            row<&Anchor::frictionAngle>("friction_angle",
                                        "Strength and what is left after it grow by tan of this angle times the "
                                        "force of the node's normal spring.",
                                        {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true},
                                         .only = limited}),
            row<&Anchor::curve>("points", "Slip and force from the origin on; unloading follows the first slope.",
                                {.unit = "m, N or N/m", .only = curved}),
            row<&Anchor::after>("after", "Past the curve's last point: its last force, or none.", {.only = curved}),
            row<&Anchor::onFailure>("on_failure", "Whether the bolt is lost with this anchor.",
                                    {.only = {.key = "law", .words = {"peak-residual", "frictional", "curve"}}}),
        }};
    return structure;
}

const Structure& structureOf(const Plate*) {
    static const Structure structure{
        "plate",
        "Ties the head of a bolt to the rock; it is lost when a force exceeds its strength.",
        defaultsOf<Plate>(),
        {
            row<&Plate::normalStiffness>("normal_stiffness", "Stiffness along the bolt.",
                                         {.unit = "N/m", .range = above(0)}),
            row<&Plate::shearStiffness>("shear_stiffness", "Stiffness across the bolt.",
                                        {.unit = "N/m", .range = above(0)}),
            row<&Plate::normalStrength>("normal_strength", "Strength along the bolt; null: unlimited.",
                                        {.unit = "N", .range = above(0)}),
            row<&Plate::shearStrength>("shear_strength", "Strength across the bolt; null: unlimited.",
                                       {.unit = "N", .range = above(0)}),
            row<&Plate::width>("width", "Width.", {.unit = "m", .range = above(0)}),
            row<&Plate::thickness>("thickness", "Thickness.", {.unit = "m", .range = above(0)}),
            row<&Plate::youngsModulus>("youngs_modulus", "Young's modulus.",
                                       {.unit = "Pa", .range = moduli, .source = boltPaper}),
            row<&Plate::poissonsRatio>("poissons_ratio", "Poisson's ratio.",
                                       {.range = between(-1, 0.5), .source = boltPaper}),
            row<&Plate::density>("density", "Mass per volume.",
                                 {.unit = "kg/m³", .range = densities, .source = usualSteel}),
        }};
    return structure;
}

const Structure& structureOf(const BoltType*) {
    static const Structure structure{
        "bolt type",
        "What bolts of one kind have in common.",
        defaultsOf<BoltType>(),
        {
            row<&BoltType::like>("like", "The type that gives every key left out here; null: none.",
                                 {.emptyIsNull = true}),
            row<&BoltType::boltClass>("class",
                                      "Continuously or discretely (C, D) mechanically or frictionally (M, F) "
                                      "coupled."),
            row<&BoltType::source>("source", "Where the numbers come from."),
            row<&BoltType::diameter>("diameter", "Diameter of the bar or tube.", {.unit = "m", .range = above(0)}),
            row<&BoltType::area>("area", "Area of steel; null: the full circle.", {.unit = "m²", .range = above(0)}),
            row<&BoltType::secondMoment>("second_moment", "Second moment of area; null: from diameter and area.",
                                         {.unit = "m⁴", .range = above(0)}),
            row<&BoltType::plasticModulus>("plastic_modulus", "Plastic section modulus; null: from diameter and area.",
                                           {.unit = "m³", .range = above(0)}),
            row<&BoltType::density>("density", "Mass per volume.",
                                    {.unit = "kg/m³", .range = densities, .source = usualSteel}),
            row<&BoltType::shearModulus>("shear_modulus", "Shear modulus.",
                                         {.unit = "Pa", .range = above(0), .source = usualSteel}),
            row<&BoltType::shearCoefficient>("shear_coefficient", "Of elements that cross a joint.",
                                             {.range = above(0), .source = boltPaper}),
            row<&BoltType::youngsModulus>("youngs_modulus",
                                          "Young's modulus; null: from the first piece of `steel`.",
                                          {.unit = "Pa", .range = moduli}),
            row<&BoltType::steel>("steel",
                                  "Strain and stress from the origin to rupture; null: linear and unbreakable.",
                                  {.unit = "–, Pa", .emptyIsNull = true}),
            row<&BoltType::tensileStrength>("tensile_strength", "Null: the largest stress of `steel`.",
                                            {.unit = "Pa", .range = above(0)}),
            row<&BoltType::shearStrengthRatio>("shear_strength_ratio", "Shear strength over tensile strength.",
                                               {.range = above(0), .source = boltPaper}),
            row<&BoltType::ruptureRule>("rupture_rule",
                                        "Tension and shear break the bar independently, or together where "
                                        "(N/N_p)² + (Q/Q_p)² reaches 1; N_p from the tensile strength, Q_p the "
                                        "shear strength.",
                                        {.source = boltPaper}),
            row<&BoltType::bending>("bending",
                                    "A bar without bending, an elastic beam, or a beam whose moment is limited by "
                                    "a plastic hinge where `steel` is given."),
            row<&BoltType::normalStiffness>("normal_stiffness",
                                            "Spring across the bolt; null: chosen by the program, per metre.",
                                            {.unit = "N/m, or N/m per m", .range = above(0)}),
            row<&BoltType::normalPer>("normal_per", "Whether that holds for each node or for each metre."),
            row<&BoltType::anchors>("anchors", "Which nodes are real anchors."),
            row<&BoltType::plate>("plate", "The plate at the head."),
            row<&BoltType::dynamicFactor>("dynamic_factor",
                                          "Dynamic over static strength of the anchors, in dynamic stages.",
                                          {.range = above(0)}),
            row<&BoltType::steelDynamicFactor>("steel_dynamic_factor",
                                               "Dynamic over static strength of the steel, in tension, shear and bending.",
                                               {.range = above(0)}),
            row<&BoltType::plateDynamicFactor>("plate_dynamic_factor", "Dynamic over static strength of the plate.", {.range = above(0)}),
            row<&BoltType::sources>("sources", "Where single numbers come from, by key."),
        }};
    return structure;
}

const Structure& structureOf(const Bolt*) {
    static const Structure structure{
        "bolt",
        "A bolt from its far end in the rock to its head.",
        defaultsOf<Bolt>(),
        {
            row<&Bolt::name>("name", "Names the bolt in tables and monitors.", {.required = true}),
            row<&Bolt::type>("type", "A type of `bolt_types`, or a built-in one.", {.required = true}),
            row<&Bolt::farEnd>("far_end", "End in the rock.", {.unit = "m", .required = true}),
            row<&Bolt::head>("head", "End at the wall.", {.unit = "m", .required = true}),
            row<&Bolt::divisions>("divisions", "Elements along the bolt; null: chosen by the program.",
                                  {.range = within(1, 100000)}),
            row<&Bolt::plate>("plate",
                              "How the head is held: not at all, by springs to the rock, or by a plate that is a block "
                              "of its own against the face."),
            row<&Bolt::spacingOutOfPlane>("spacing_out_of_plane",
                                          "Distance to the next bolt out of the plane; null: the thickness.",
                                          {.unit = "m", .range = above(0)}),
            row<&Bolt::pretension>("pretension",
                                   "Force to which the plate pulls the head when the bolt is installed; then it "
                                   "locks off. Needs a plate.",
                                   {.unit = "N", .range = atLeast(0)}),
            row<&Bolt::anchors>("anchors", "Anchors of this bolt; null: those of its type."),
            row<&Bolt::dynamicFactor>("dynamic_factor",
                                      "Dynamic over static strength of its anchors, in dynamic stages; null: as its "
                                      "type.",
                                      {.range = above(0)}),
            row<&Bolt::steelDynamicFactor>("steel_dynamic_factor", "Dynamic over static strength of its steel; null: as its type.",
                                           {.range = above(0)}),
            row<&Bolt::plateDynamicFactor>("plate_dynamic_factor", "Dynamic over static strength of its plate; null: as its type.",
                                           {.range = above(0)}),
        }};
    return structure;
}

const Structure& structureOf(const ScenePattern*) {
    static const Structure structure{
        "bolt pattern",
        "Bolts at equal lengths along the wall of a tunnel, named after the pattern: `P1.1`, `P1.2`, … in the order of "
        "`way`.",
        defaultsOf<ScenePattern>(),
        {
            row<&ScenePattern::name>("name", "Names the pattern and its bolts.", {.required = true}),
            row<&ScenePattern::type>("type", "A type of `bolt_types`, or a built-in one.", {.required = true}),
            row<&ScenePattern::tunnel>("tunnel", "Name of the tunnel.", {.required = true}),
            row<&ScenePattern::from>("from", "The pattern begins at the place of the wall nearest to this.",
                                     {.unit = "m", .required = true}),
            row<&ScenePattern::to>("to", "It ends at the place nearest to this; where both are one, it goes all round.",
                                   {.unit = "m", .required = true}),
            row<&ScenePattern::way>("way", "Which way round the wall, as the section is drawn."),
            row<&ScenePattern::spacing>("spacing", "Between heads, along the wall.",
                                        {.unit = "m", .range = above(0), .required = true}),
            row<&ScenePattern::offset>("offset", "Of the first head from the beginning, along the wall.",
                                       {.unit = "m", .range = atLeast(0)}),
            row<&ScenePattern::length>("length", "Length of a bolt.",
                                       {.unit = "m", .range = above(0), .required = true}),
            row<&ScenePattern::angleFromWall>("angle_from_wall",
                                              "Between the bolt and the wall's tangent in the direction of `way`.",
                                              {.unit = "°",
                                               .range = within(leastAngleFromWall, greatestAngleFromWall)}),
            row<&ScenePattern::divisions>("divisions", "Elements along each bolt; null: chosen by the program.",
                                          {.range = within(1, 100000)}),
            row<&ScenePattern::plate>("plate", "How the heads are held, as of a bolt."),
            row<&ScenePattern::spacingOutOfPlane>("spacing_out_of_plane",
                                                  "Distance to the next row out of the plane; null: the thickness.",
                                                  {.unit = "m", .range = above(0)}),
            row<&ScenePattern::pretension>("pretension", "Force to which each plate pulls its head, as of a bolt.",
                                           {.unit = "N", .range = atLeast(0)}),
        }};
    return structure;
}

}  // namespace keyblock
