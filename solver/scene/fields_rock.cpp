// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Field table of the rock: materials, joints, blocks and supports.
#include "solver/scene/automatic.h"
#include "solver/scene/field_rows.h"

namespace keyblock {

namespace {

constexpr std::string_view stiffness = translatable("Fields", "Stiffness");
constexpr std::string_view sxxLabel = translatable("Fields", "σxx");
constexpr std::string_view syyLabel = translatable("Fields", "σyy");
constexpr std::string_view sxyLabel = translatable("Fields", "σxy");

double peakAngle(const JointMaterial& material) { return material.frictionAngle; }

FieldValue shearStiffnessOf(const Scene& scene, const JointMaterial& material) {
    return material.normalStiffness ? FieldValue(scene.analysis.shearRatio * *material.normalStiffness) : FieldValue();
}

}  // namespace

const Structure& structureOf(const Material*) {
    static const Structure structure{
        "material",
        "Linear elastic rock.",
        defaultsOf<Material>(),
        {
            row<&Material::density>("density", "Mass per volume.",
                                    {.unit = "kg/m³", .range = densities, .required = true}),
            row<&Material::youngsModulus>("youngs_modulus", "Young's modulus.",
                                          {.label = translatable("Fields", "Young's modulus"), .unit = "Pa",
                                           .isModulus = true, .range = moduli, .required = true}),
            row<&Material::poissonsRatio>("poissons_ratio", "Poisson's ratio.",
                                          {.label = translatable("Fields", "Poisson's ratio"),
                                           .range = between(-1, 0.5), .required = true}),
        }};
    return structure;
}

const Structure& structureOf(const JointMaterial*) {
    static const Structure structure{
        "joint material",
        "Mohr–Coulomb strength of the faces of blocks; cohesion and tensile strength are lost at the first failure.",
        defaultsOf<JointMaterial>(),
        {
            row<&JointMaterial::frictionAngle>(
                "friction_angle", "Friction angle.",
                {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true}}),
            row<&JointMaterial::cohesion>("cohesion", "Cohesion on the contact length.",
                                          {.unit = "Pa", .range = atLeast(0)}),
            row<&JointMaterial::tensileStrength>("tensile_strength",
                                                 "Tensile strength on the contact length. A bent joint cracks at "
                                                 "`tensile_strength`·h²/6 per metre of thickness where blocks have "
                                                 "`sub_blocks`, at three times that between whole blocks.",
                                                 {.unit = "Pa", .range = atLeast(0)}),
            row<&JointMaterial::residualFrictionAngle>(
                "residual_friction_angle",
                "Friction angle of a contact after its first slip; null: unchanged. At most `friction_angle`.",
                {.unit = "°", .range = {.least = 0.0, .most = 90.0, .mostExcluded = true},
                 .automatic = automatic<peakAngle>}),
            row<&JointMaterial::normalStiffness>(
                "normal_stiffness", "Stiffness of the joint itself where faces meet; null: from `penalty_ratio`.",
                {.unit = "Pa/m", .range = above(0), .heading = stiffness}),
            row<&JointMaterial::shearStiffness>(
                "shear_stiffness", "The same in shear; null: `shear_ratio` times the normal stiffness.",
                {.unit = "Pa/m", .range = above(0), .heading = stiffness, .automatic = automatic<shearStiffnessOf>}),
            row<&JointMaterial::crushingStrength>("crushing_strength",
                                                  "Bearing pressure on the diameter of a bolt at which rock or grout "
                                                  "crushes under it, in the blocks of this material; null: no limit.",
                                                  {.unit = "Pa", .range = above(0), .heading = stiffness,
                                                   .nullText = translatable("Fields", "no limit")}),
        }};
    return structure;
}

const Structure& structureOf(const CellSettings*) {
    static const Structure structure{
        "sub-blocks",
        "Cuts a block into cells of about equal size along its longest edge, joined by an elastic bond that never "
        "fails. Each cell has its own stress and is named after the block: `beam:1`, `beam:2`, … column by column.",
        defaultsOf<CellSettings>(),
        {
            row<&CellSettings::size>("size", "Approximate size of a cell: the block's bounding box is divided into "
                                             "whole cells.",
                                     {.unit = "m", .range = above(0), .required = true}),
        }};
    return structure;
}

const Structure& structureOf(const Block*) {
    static const Structure structure{
        "block",
        "A block of rock with constant stress, or cut into cells that each have a stress of their own.",
        defaultsOf<Block>(),
        {
            row<&Block::name>("name", "Name of the block; without one it is called `b1`, `b2`, … by its number."),
            row<&Block::points>("points", "Corners, clockwise or counter-clockwise, the first not repeated.",
                                {.unit = "m", .required = true}),
            row<&Block::material>("material", "Name of its material.", {.required = true, .names = {"materials"}}),
            row<&Block::jointMaterial>("joint_material",
                                       "Name of the joint material of its faces; null: the first of "
                                       "`joint_materials`.",
                                       {.names = {"joint_materials"}, .automatic = automatic<automaticJointMaterial>}),
            row<&Block::initialStress>("initial_stress",
                                       "Initial stress sxx, syy, sxy; tension is positive in a file.",
                                       {.unit = "Pa", .isStress = true}),
            row<&Block::subBlocks>("sub_blocks", "Cells to cut the block into; null: none.",
                                   {.label = translatable("Fields", "Cells")}),
        }};
    return structure;
}

const Structure& structureOf(const StressGradient*) {
    static const Structure structure{
        "stress gradient",
        "Change of the stress per metre of elevation.",
        defaultsOf<StressGradient>(),
        {
            row<&StressGradient::sxx>("sxx", "Gradient of the horizontal stress.",
                                      {.label = sxxLabel, .unit = "Pa/m", .isStress = true}),
            row<&StressGradient::syy>("syy", "Gradient of the vertical stress: density times gravity (tension "
                                             "positive) where it carries the rock above.",
                                      {.label = syyLabel, .unit = "Pa/m", .isStress = true}),
            row<&StressGradient::sxy>("sxy", "Gradient of the shear stress.",
                                      {.label = sxyLabel, .unit = "Pa/m", .isStress = true}),
        }};
    return structure;
}

const Structure& structureOf(const InSituStress*) {
    static const Structure structure{
        "in-situ stress",
        "Stress in the rock before excavation; tension is positive in a file. Blocks, contacts, cells and point "
        "supports start with it, in addition to `initial_stress`; blocks that are not in equilibrium under it move in "
        "the first stage.",
        defaultsOf<InSituStress>(),
        {
            row<&InSituStress::sxx>("sxx", "Horizontal stress at `reference_y`.",
                                    {.label = sxxLabel, .unit = "Pa", .isStress = true}),
            row<&InSituStress::syy>("syy", "Vertical stress at `reference_y`.",
                                    {.label = syyLabel, .unit = "Pa", .isStress = true}),
            row<&InSituStress::sxy>("sxy", "Shear stress at `reference_y`.",
                                    {.label = sxyLabel, .unit = "Pa", .isStress = true}),
            row<&InSituStress::gradientY>("gradient_y", "Gradient of the stress with elevation.",
                                          {.label = translatable("Fields", "Gradient with elevation")}),
            row<&InSituStress::referenceY>("reference_y", "Elevation at which the stress has the given values.",
                                           {.label = translatable("Fields", "Reference elevation"), .unit = "m",
                                            .range = coordinates}),
        }};
    return structure;
}

const Structure& structureOf(const Support*) {
    static const Structure structure{
        "support",
        "Fixes a whole block (`block_at`, fix `all`), a point of a block (`point`, fix `x`, `y` or `xy`), or a side of "
        "the domain (`boundary`): with fix `all` every block that has a face there, otherwise the corners of those "
        "faces. Whole blocks do not move at all; points and corners are supported by springs of stiffness "
        "`penalty_ratio` × E × thickness and move by the force divided by that stiffness.",
        defaultsOf<Support>(),
        {
            row<&Support::blockAt>("block_at", "A point inside the block that is fixed.",
                                   {.label = translatable("Fields", "Point in block"), .unit = "m"}),
            row<&Support::point>("point", "The point that is fixed, in a block or on its boundary.", {.unit = "m"}),
            row<&Support::boundary>("boundary",
                                    "The side of the domain that is fixed. An edge of the boundary belongs to the side "
                                    "that its outward normal points to, at 45° to bottom or top."),
            row<&Support::fix>("fix", "Displacements that are fixed; `all`: those of a whole block.",
                               {.label = translatable("Fields", "Fixity")}),
        }};
    return structure;
}

}  // namespace keyblock
