// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Field table of bolts, their types, anchors and plates.
#include "geometry/shape/bolt_pattern.h"
#include "solver/scene/automatic.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/field_rows.h"

namespace keyblock {

namespace {

constexpr std::string_view boltPaper = "unified rock bolt model in DDA";
constexpr std::string_view usualSteel = "typical value for steel";

constexpr std::string_view ofBolt = translatable("Fields", "Bolt");
constexpr std::string_view bondLabel = translatable("Fields", "Bond");
constexpr std::string_view steelLabel = translatable("Fields", "Steel");
constexpr std::string_view plateLabel = translatable("Fields", "Plate");
constexpr std::string_view grout = translatable("Fields", "Transverse stiffness of the grout");
constexpr std::string_view dynamicStrength = translatable("Fields", "Dynamic / static strength");
constexpr std::string_view unlimited = translatable("Fields", "unlimited");
constexpr std::string_view outOfPlaneSpacing = translatable("Fields", "Out-of-plane spacing");

// True if values are per metre of the bolt, false if they are per node. Used for anchors and the grout.
bool perLength(const void* object, const void*) {
    const auto& anchor = *static_cast<const Anchor*>(object);
    return !anchor.at && anchor.per == Per::Length;
}

double thicknessOf(const Scene& scene) { return scene.analysis.thickness; }

double areaOf(const BoltType& type) { return fullBarArea(type.diameter); }

FieldValue tensileStrengthOf(const Scene&, const BoltType& type) {
    BoltType plain = type;
    plain.tensileStrength.reset();
    const BoltSteel steel = boltSteel(plain);
    return steel.tensile ? FieldValue(*steel.tensile / steel.area) : FieldValue();
}

template <double BoltType::*factor>
FieldValue factorOfType(const Scene& scene, const Bolt& bolt) {
    const BoltType* type = findBoltType(scene, bolt.type);
    return type ? FieldValue(type->*factor) : FieldValue();
}

bool normalPerLength(const void* object, const void*) {
    return static_cast<const BoltType*>(object)->normalPer == Per::Length;
}

/// Limits a field to the anchor laws for which `has` is true.
Only ofLaws(bool (*has)(const AnchorLawRow&)) {
    Only only{.key = "law", .words = {}};
    for (const AnchorLawRow& row : anchorLaws)
        if (has(row)) only.words.push_back(row.key);
    return only;
}

}  // namespace

const Structure& structureOf(const Anchor*) {
    static const Only noCurve = ofLaws([](const AnchorLawRow& row) { return !row.hasPoints; });
    static const Only limited = ofLaws([](const AnchorLawRow& row) { return row.hasStrength; });
    static const Only residual = ofLaws([](const AnchorLawRow& row) { return row.hasResidual; });
    static const Only curved = ofLaws([](const AnchorLawRow& row) { return row.hasPoints; });
    static const Only failing = ofLaws([](const AnchorLawRow& row) { return canFail(row); });
    static const Structure structure{
        "anchor",
        "Bonds nodes of a bolt to the rock (real anchors): the node nearest to `at`, or the nodes from `from` to `to`. "
        "Later entries override earlier ones; nodes in no entry are intermediate nodes (artificial anchors), supported "
        "across the bolt and free along it.",
        defaultsOf<Anchor>(),
        {
            row<&Anchor::at>("at", "Position along the bolt from its far end; `head`: at its head.",
                             {.unit = "m", .range = atLeast(0)}),
            row<&Anchor::from>("from", "Start of the range, from the far end.", {.unit = "m", .range = atLeast(0)}),
            row<&Anchor::to>("to", "End of the range, from the far end.", {.unit = "m", .range = atLeast(0)}),
            row<&Anchor::per>("per",
                              "Whether values apply to each node or to each metre of embedded bolt; those of an `at` "
                              "entry apply to its node.", {.label = translatable("Fields", "Values given per")}),
            row<&Anchor::law>("law",
                              "Elastic without limit; peak, then residual; friction at constant strength; or a "
                              "force–slip curve.",
                              {.required = true}),
            row<&Anchor::stiffness>("stiffness", "Tangential stiffness.",
                                    {.unit = "N/m, or N/m per m", .takesSecond = perLength, .range = atLeast(0),
                                     .only = noCurve}),
            row<&Anchor::strength>("strength", "Force at which the anchor fails.",
                                   {.unit = "N, or N/m", .takesSecond = perLength, .range = above(0),
                                    .only = limited}),
            row<&Anchor::residual>("residual", "Friction that remains after failure.",
                                   {.unit = "N, or N/m", .takesSecond = perLength, .range = atLeast(0),
                                    .only = residual}),
            row<&Anchor::softeningSlip>("softening_slip",
                                        "Slip from the peak to the residual, linear; 0: brittle. Fracture energy "
                                        "per metre: ½·(strength − residual)·(slip + (strength − residual)/stiffness).",
                                        {.unit = "m", .range = atLeast(0), .only = residual}),
            row<&Anchor::restick>("restick",
                                  "Whether the anchor re-sticks when its sliding stops; otherwise it keeps the force "
                                  "it had after failure.",
                                  {.label = translatable("Fields", "Re-stick"), .only = limited}),
            row<&Anchor::frictionAngle>("friction_angle",
                                        "Peak and residual strength increase by the tangent of this angle times the "
                                        "force of the node's normal spring.",
                                        {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true},
                                         .only = limited}),
            row<&Anchor::curve>("points", "Slip and force, starting at the origin; unloading follows the first slope.",
                                {.unit = "m, N or N/m", .takesSecond = perLength,
                                 .columns = {{translatable("Fields", "Slip"), "m", "m"},
                                             {translatable("Fields", "Force"), "N", "N/m"}},
                                 .only = curved}),
            row<&Anchor::after>("after", "Force beyond the last point of the curve: the "
                                         "last force, or none.", {.only = curved}),
            row<&Anchor::onFailure>("on_failure", "Whether the bolt is lost when this anchor fails.",
                                    {.only = failing}),
        }};
    return structure;
}

const Structure& structureOf(const Plate*) {
    static const Structure structure{
        "plate",
        "Face plate that ties the head of a bolt to the rock; it is lost when a force exceeds its strength.",
        defaultsOf<Plate>(),
        {
            row<&Plate::normalStiffness>("normal_stiffness", "Stiffness along the bolt.",
                                         {.unit = "N/m", .range = above(0)}),
            row<&Plate::shearStiffness>("shear_stiffness", "Stiffness across the bolt.",
                                        {.unit = "N/m", .range = above(0)}),
            row<&Plate::normalStrength>("normal_strength", "Strength along the bolt; null: unlimited.",
                                        {.unit = "N", .range = above(0), .nullText = unlimited}),
            row<&Plate::shearStrength>("shear_strength", "Strength across the bolt; null: unlimited.",
                                       {.unit = "N", .range = above(0), .nullText = unlimited}),
            row<&Plate::width>("width", "Width.", {.unit = "m", .range = above(0)}),
            row<&Plate::thickness>("thickness", "Thickness.", {.unit = "m", .range = above(0)}),
            row<&Plate::youngsModulus>("youngs_modulus", "Young's modulus.",
                                       {.label = translatable("Fields", "Young's modulus"), .unit = "Pa",
                                        .isModulus = true, .range = moduli, .source = boltPaper}),
            row<&Plate::poissonsRatio>("poissons_ratio", "Poisson's ratio.",
                                       {.label = translatable("Fields", "Poisson's ratio"), .range = between(-1, 0.5),
                                        .source = boltPaper}),
            row<&Plate::density>("density", "Mass per volume.",
                                 {.unit = "kg/m³", .range = densities, .source = usualSteel}),
        }};
    return structure;
}

const Structure& structureOf(const BoltType*) {
    static const Structure structure{
        "bolt type",
        "Properties shared by bolts of one kind.",
        defaultsOf<BoltType>(),
        {
            row<&BoltType::like>("like", "Type that supplies all values that are not given here; null: none.",
                                 {.label = translatable("Fields", "Derived from"), .emptyIsNull = true,
                                  .names = {"bolt_types"}}),
            row<&BoltType::boltClass>("class",
                                      "Coupling: continuous or discrete (C, D), mechanical or frictional (M, F)."),
            row<&BoltType::source>("source", "Source of the numbers.", {.isSentence = true}),
            row<&BoltType::diameter>("diameter", "Diameter of the bar or tube.",
                                     {.unit = "m", .range = above(0), .heading = steelLabel}),
            row<&BoltType::area>("area", "Area of steel; null: the full circle "
                                         "of the diameter.",
                                 {.unit = "m²", .range = above(0), .heading = steelLabel,
                                  .automatic = automatic<areaOf>}),
            row<&BoltType::secondMoment>("second_moment", "Second moment of area; null: from diameter and area.",
                                         {.label = translatable("Fields", "Second moment of area"), .unit = "m⁴",
                                          .range = above(0), .heading = steelLabel,
                                          .automatic = automatic<automaticSecondMoment>}),
            row<&BoltType::plasticModulus>("plastic_modulus", "Plastic section modulus; null: from diameter and area.",
                                           {.unit = "m³", .range = above(0), .heading = steelLabel,
                                            .automatic = automatic<automaticPlasticModulus>}),
            row<&BoltType::density>("density", "Mass per volume.",
                                    {.unit = "kg/m³", .range = densities, .source = usualSteel,
                                     .heading = steelLabel}),
            row<&BoltType::shearModulus>("shear_modulus", "Shear modulus.",
                                         {.unit = "Pa", .isModulus = true, .range = above(0), .source = usualSteel,
                                          .heading = steelLabel}),
            row<&BoltType::shearCoefficient>("shear_coefficient", "Shear coefficient of elements that cross a joint.",
                                             {.range = above(0), .source = boltPaper, .heading = steelLabel}),
            row<&BoltType::youngsModulus>("youngs_modulus",
                                          "Young's modulus; null: from the first piece of `steel`.",
                                          {.label = translatable("Fields", "Young's modulus"), .unit = "Pa",
                                           .isModulus = true, .range = moduli, .heading = steelLabel,
                                           .automatic = automatic<automaticYoungsModulus>}),
            row<&BoltType::steel>("steel",
                                  "Strain and stress from the origin to rupture; null: linear, without rupture.",
                                  {.unit = "–, Pa",
                                   .columns = {{translatable("Fields", "Strain")},
                                               {translatable("Fields", "Stress"), "Pa"}},
                                   .emptyIsNull = true, .heading = steelLabel}),
            row<&BoltType::tensileStrength>("tensile_strength", "Tensile strength; null: the largest stress of "
                                                                "`steel`.",
                                            {.unit = "Pa", .range = above(0), .heading = steelLabel,
                                             .automatic = automatic<tensileStrengthOf>}),
            row<&BoltType::shearStrengthRatio>("shear_strength_ratio", "Shear strength over tensile strength.",
                                               {.range = above(0), .source = boltPaper, .heading = steelLabel}),
            row<&BoltType::ruptureRule>("rupture_rule",
                                        "Tension and shear break the bar independently, or together where "
                                        "(N/N_p)² + (Q/Q_p)² reaches 1; N_p from the tensile strength, Q_p the "
                                        "shear strength.", {.source = boltPaper, .heading = steelLabel}),
            row<&BoltType::bending>("bending",
                                    "A bar without bending, an elastic beam, or a beam whose moment is limited by "
                                    "a plastic hinge where `steel` is given.", {.heading = steelLabel}),
            row<&BoltType::normalStiffness>("normal_stiffness",
                                            "Stiffness of the springs across the bolt; null: chosen by the program, "
                                            "per metre.",
                                            {.unit = "N/m, or N/m per m", .takesSecond = normalPerLength,
                                             .range = above(0), .heading = grout}),
            row<&BoltType::normalPer>("normal_per", "Whether that stiffness applies to each node or to each metre.",
                                      {.label = translatable("Fields", "Stiffness given per"), .heading = grout}),
            row<&BoltType::anchors>("anchors", "Nodes that are bonded to the rock (real anchors)."),
            row<&BoltType::plate>("plate", "Face plate at the head."),
            row<&BoltType::dynamicFactor>("dynamic_factor",
                                          "Dynamic over static strength of the anchors, in dynamic stages.",
                                          {.label = bondLabel, .range = above(0), .heading = dynamicStrength}),
            row<&BoltType::steelDynamicFactor>("steel_dynamic_factor",
                                               "Dynamic over static strength of the steel, in tension, shear and bending.",
                                               {.label = steelLabel, .range = above(0), .heading = dynamicStrength}),
            row<&BoltType::plateDynamicFactor>("plate_dynamic_factor", "Dynamic over static strength of the plate.",
                                               {.label = plateLabel, .range = above(0), .heading = dynamicStrength}),
            row<&BoltType::sources>("sources", "Sources of single numbers, by key.",
                                    {.heading = translatable("Fields", "Sources")}),
        }};
    return structure;
}

const Structure& structureOf(const Bolt*) {
    static const Structure structure{
        "bolt",
        "A bolt from its far end (toe) in the rock to its head (collar).",
        defaultsOf<Bolt>(),
        {
            row<&Bolt::name>("name", "Name of the bolt in tables and monitors.", {.required = true}),
            row<&Bolt::type>("type", "A type of `bolt_types`, or a built-in one.",
                             {.required = true, .names = {"bolt_types"}}),
            row<&Bolt::farEnd>("far_end", "End in the rock.", {.unit = "m", .required = true}),
            row<&Bolt::head>("head", "End at the wall.", {.unit = "m", .required = true}),
            row<&Bolt::divisions>("divisions", "Elements along the bolt; null: chosen by the program.",
                                  {.range = within(1, 100000)}),
            row<&Bolt::plate>("plate",
                              "Support of the head: none, springs to the rock, or a plate modelled as a block of its "
                              "own against the face."),
            row<&Bolt::spacingOutOfPlane>("spacing_out_of_plane",
                                          "Distance to the next bolt out of the plane; null: the thickness.",
                                          {.label = outOfPlaneSpacing, .unit = "m", .range = above(0),
                                           .automatic = automatic<thicknessOf>}),
            row<&Bolt::pretension>("pretension",
                                   "Force to which the head is tensioned against the plate when the bolt is installed; "
                                   "it is then locked off. Needs a plate.",
                                   {.unit = "N", .range = atLeast(0)}),
            row<&Bolt::anchors>("anchors", "Anchors of this bolt; null: those of its type."),
            row<&Bolt::dynamicFactor>("dynamic_factor",
                                      "Dynamic over static strength of its anchors, in dynamic stages; null: that of "
                                      "its type.",
                                      {.label = bondLabel, .range = above(0), .heading = dynamicStrength,
                                       .automatic = automatic<factorOfType<&BoltType::dynamicFactor>>}),
            row<&Bolt::steelDynamicFactor>("steel_dynamic_factor", "Dynamic over static strength of its steel; null: "
                                                                   "that of its type.",
                                           {.label = steelLabel, .range = above(0), .heading = dynamicStrength,
                                            .automatic = automatic<factorOfType<&BoltType::steelDynamicFactor>>}),
            row<&Bolt::plateDynamicFactor>("plate_dynamic_factor", "Dynamic over static strength of its plate; null: "
                                                                   "that of its type.",
                                           {.label = plateLabel, .range = above(0), .heading = dynamicStrength,
                                            .automatic = automatic<factorOfType<&BoltType::plateDynamicFactor>>}),
        }};
    return structure;
}

const Structure& structureOf(const ScenePattern*) {
    static const Structure structure{
        "bolt pattern",
        "Bolts at equal spacing along the wall of a tunnel, named after the pattern: `P1.1`, `P1.2`, … in the "
        "direction of `way`.",
        defaultsOf<ScenePattern>(),
        {
            row<&ScenePattern::name>("name", "Name of the pattern, from which its "
                                             "bolts are named.", {.required = true}),
            row<&ScenePattern::type>("type", "A type of `bolt_types`, or a built-in one.",
                                     {.required = true, .names = {"bolt_types"}, .heading = ofBolt}),
            row<&ScenePattern::tunnel>("tunnel", "Name of the tunnel.",
                                       {.required = true, .names = {"tunnels"}}),
            row<&ScenePattern::from>("from", "The pattern starts at the point of the wall nearest to this point.",
                                     {.unit = "m", .required = true}),
            row<&ScenePattern::to>("to", "The pattern ends at the point of the wall nearest to this point; if it is "
                                         "also the start, the pattern runs all round the tunnel.",
                                   {.unit = "m", .required = true}),
            row<&ScenePattern::way>("way", "Direction along the wall in the drawn section: counter-clockwise or "
                                           "clockwise.", {.label = translatable("Fields", "Direction")}),
            row<&ScenePattern::spacing>("spacing", "Distance between heads along the wall.",
                                        {.unit = "m", .range = above(0), .required = true}),
            row<&ScenePattern::offset>("offset", "Distance of the first head from the start along the wall.",
                                       {.label = translatable("Fields", "Offset of first bolt"), .unit = "m",
                                        .range = atLeast(0)}),
            row<&ScenePattern::length>("length", "Length of a bolt.",
                                       {.unit = "m", .range = above(0), .required = true, .heading = ofBolt}),
            row<&ScenePattern::angleFromWall>("angle_from_wall",
                                              "Angle between the bolt and the wall's tangent in the direction of "
                                              "`way`.",
                                              {.unit = "°", .range = within(leastAngleFromWall, greatestAngleFromWall),
                                               .heading = ofBolt}),
            row<&ScenePattern::divisions>("divisions", "Elements along each bolt; null: chosen by the program.",
                                          {.range = within(1, 100000), .heading = ofBolt}),
            row<&ScenePattern::plate>("plate", "Support of the heads, as for a bolt.", {.heading = ofBolt}),
            row<&ScenePattern::spacingOutOfPlane>("spacing_out_of_plane",
                                                  "Distance to the next row out of the plane; null: the thickness.",
                                                  {.label = outOfPlaneSpacing, .unit = "m", .range = above(0),
                                                   .automatic = automatic<thicknessOf>}),
            row<&ScenePattern::pretension>("pretension", "Force to which each head is tensioned against its plate, as "
                                                         "for a bolt.",
                                           {.unit = "N", .range = atLeast(0), .heading = ofBolt}),
        }};
    return structure;
}

}  // namespace keyblock
