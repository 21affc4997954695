// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows that need no template.
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
        "One scene per file. Lengths are in metres, forces in newtons; angles that a person types in degrees.",
        defaultsOf<Scene>(),
        {
            fixedRow("format", "Says what kind of file this is.", {std::string("keyblock-scene")}, true),
            fixedRow("version", "Version of the format.", {1.0}, true),
            row<&Scene::title>("title", "What the scene is called."),
            row<&Scene::about>("about", "What the scene shows, where it comes from and which numbers are expected."),
            row<&Scene::analysis>("analysis", "Settings of the whole analysis."),
            row<&Scene::materials>("materials", "Rock, by name."),
            row<&Scene::jointMaterials>("joint_materials",
                                        "Strength of joints, by name. Blocks that name none take the first; without "
                                        "any, joints have 30° of friction."),
            row<&Scene::domain>("domain", "A region that joints, joint sets, Voronoi cells and tunnels cut into blocks."),
            row<&Scene::cutting>("cutting", "Limits of the cut."),
            row<&Scene::joints>("joints", "Single joints."),
            row<&Scene::jointSets>("joint_sets", "Joint sets."),
            row<&Scene::voronoi>("voronoi", "Voronoi cells; null: none."),
            row<&Scene::regions>("regions", "Parts of the section that joint sets and Voronoi cells refer to."),
            row<&Scene::tunnels>("tunnels", "Openings in the domain."),
            row<&Scene::blocks>("blocks", "Blocks given by their corners. They may touch each other and the domain, and stand "
                                          "in its tunnels that no stage excavates, but not overlap. The blocks of the "
                                          "domain follow them: the first without a name "
                                          "is `b` and its place among all."),
            row<&Scene::supports>("supports", "What is held."),
            row<&Scene::inSituStress>("in_situ_stress", "Stress before anything is excavated; null: none."),
            row<&Scene::boltTypes>("bolt_types", "Bolt types of this scene, by name, beside the built-in ones."),
            row<&Scene::bolts>("bolts", "The bolts."),
            row<&Scene::boltPatterns>("bolt_patterns", "Bolts round tunnels."),
            row<&Scene::stages>("stages", "What happens, one after another; a scene without is checked, not run."),
            row<&Scene::monitors>("monitors", "Places and bolts whose values the history keeps."),
            row<&Scene::quantities>("quantities",
                                    "Numbers of interest: `max|min|last MONITOR[.ux|.uy]`, `max|min|last "
                                    "BOLT.QUANTITY`, `first KIND MONITOR[.ux|.uy]` (just before the first such "
                                    "event)."),
            row<&Scene::safety>("safety", "How the factor of safety is looked for."),
            row<&Scene::output>("output", "What a run keeps."),
            row<&Scene::limits>("limits", "Where a run ends even if its stages do not."),
        }};
    return structure;
}

const Structure& boltTypeStructure() { return structureOf(static_cast<const BoltType*>(nullptr)); }

}  // namespace keyblock
