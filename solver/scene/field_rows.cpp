// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of the field table that need no template, and the structure of the
// scene.
#include "solver/scene/field_rows.h"

namespace keyblock {

Field fixedRow(std::string_view key, std::string_view help, std::vector<FieldValue> accepted, bool required) {
    Field field{.key = key, .kind = FieldKind::Fixed, .help = help};
    field.accepted = std::move(accepted);
    field.required = required;
    return field;
}

const Structure& sceneStructure() {
    static const Structure structure{
        "scene",
        "One scene per file. Lengths are in metres, forces in newtons and, unless another unit is given, angles in "
        "degrees.",
        defaultsOf<Scene>(),
        {
            fixedRow("format", "File type.", {std::string("keyblock-scene")}, true),
            fixedRow("version", "Version of the format.", {1.0}, true),
            row<&Scene::title>("title", "Title of the scene.", {.isSentence = true}),
            row<&Scene::about>("about", "Description, source and expected results of the scene.", {.isRare = true}),
            row<&Scene::analysis>("analysis", "Settings of the whole analysis."),
            row<&Scene::materials>("materials", "Rock, by name."),
            row<&Scene::jointMaterials>("joint_materials",
                                        "Strength of joints, by name. Blocks that name none take the first; without "
                                        "any, joints have 30° of friction."),
            row<&Scene::domain>("domain",
                                "A region that joints, joint sets, Voronoi cells and tunnels cut into blocks."),
            row<&Scene::cutting>("cutting", "Limits of the cut."),
            row<&Scene::joints>("joints", "Single joints."),
            row<&Scene::jointSets>("joint_sets", "Joint sets."),
            row<&Scene::voronoi>("voronoi", "Voronoi cells; null: none."),
            row<&Scene::regions>("regions", "Parts of the section that joint sets and Voronoi cells refer to."),
            row<&Scene::tunnels>("tunnels", "Openings in the domain."),
            row<&Scene::blocks>("blocks",
                                "Blocks given by their corners. They may touch each other and the domain and "
                                "may lie in tunnels that no stage excavates, but must not overlap. The "
                                "blocks of the domain are numbered after them: a block without a name is "
                                "called `b` followed by its number among all blocks."),
            row<&Scene::supports>("supports", "Fixed blocks, points and sides of the domain."),
            row<&Scene::inSituStress>("in_situ_stress", "Stress before excavation; null: none.",
                                      {.label = translatable("Fields", "In-situ stress")}),
            row<&Scene::boltTypes>("bolt_types",
                                   "Bolt types of this scene, by name, in addition to the built-in "
                                   "types."),
            row<&Scene::bolts>("bolts", "Single bolts."),
            row<&Scene::boltPatterns>("bolt_patterns", "Bolts round tunnels."),
            row<&Scene::stages>("stages",
                                "Stages of the run, in order; a scene without stages can be checked but not "
                                "run.",
                                {.isOrdered = true}),
            row<&Scene::monitors>("monitors", "Points and bolts whose values are recorded in the history."),
            row<&Scene::quantities>(
                "quantities",
                "Results of interest: `max|min|last MONITOR[.ux|.uy|.u]` (`.u` is the magnitude "
                "of a displacement), `max|min|last BOLT.QUANTITY`, `first KIND "
                "MONITOR[.ux|.uy|.u]` (just before the first such event), `count KIND`, `order "
                "KIND` (the bolts, joints or blocks in order of the first such event of each), `energy_error`, "
                "`factor_of_safety`, `stands` (1 if the scene is stable, otherwise 0).",
                {.heading = translatable("Fields", "Quantities of interest"), .isRare = true}),
            row<&Scene::safety>("safety", "Settings of the search for the factor of safety."),
            row<&Scene::output>("output", "Results that a run saves."),
            row<&Scene::limits>("limits", "Limits at which a run ends even if its stages are not finished."),
        }};
    return structure;
}

const Structure& boltTypeStructure() { return structureOf(static_cast<const BoltType*>(nullptr)); }

}  // namespace keyblock
