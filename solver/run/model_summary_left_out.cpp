// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is not modelled because the scene does not need it: which setting decides this,
// and what it saves.
#include "solver/run/model_summary.h"

#include "solver/engine/contact/multipliers.h"
#include "solver/run/stage_settings.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"

#include <algorithm>

namespace keyblock {
namespace {

std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

class LeftOutList {
public:
    LeftOutList(const Scene& scene, const Model& model, const ModelCounts& counts)
        : scene_(scene), model_(model), counts_(counts) {}

    std::vector<LeftOut> make(const SceneCut* cut) {
        addRock(cut);
        addContacts();
        addBolts();
        addStages();
        return std::move(list_);
    }

private:
    void add(bool applies, std::string what, std::string why, std::string saves) {
        if (applies) list_.push_back({std::move(what), std::move(why), std::move(saves)});
    }

    void addRock(const SceneCut* cut) {
        const int open = cut ? cut->open : 0;
        add(open > 0, "rock in tunnels", "no stage excavates them, so they are open from the start",
            counted(open, "block") + " of six unknowns" + (open == 1 ? "" : " each"));
        add(counts_.fixed > 0, "motion of fixed blocks", "a support fixes them completely (\"fix\": \"all\")",
            counted(6 * counts_.fixed, "unknown"));
        add(prescribed() > 0, "prescribed displacements", "they are known and not unknowns of a step while they apply",
            counted(prescribed(), "unknown"));
        add(counts_.cells == 0, "stress variation within blocks", "no block has 'sub_blocks'",
            "six unknowns per cell, three springs per edge between cells");
        add(model_.gravity.isZero(0.0), "weight", "'gravity' is zero", "a load on every block and node");
        add(!scene_.inSituStress, "stress before excavation", "there is no 'in_situ_stress'",
            "the search for joint forces in equilibrium with it");
    }

    void addContacts() {
        add(counts_.contacts > 0 && !usesMultipliers(model_), "forces that keep contacts closed exactly",
            "'contact' is \"penalty\"", counted(2 * counts_.contacts, "multiplier") + ", up to 40 solutions per step");
        const auto bonded = [](const JointModel& joint) { return joint.cohesion > 0.0 || joint.tensileStrength > 0.0; };
        const auto own = model_.joints.begin() + static_cast<std::ptrdiff_t>(scene_.jointMaterials.size());
        add(counts_.contacts > 0 && std::none_of(model_.joints.begin(), own, bonded), "failure of joint bonds",
            "no joint material has cohesion or tensile strength", "an event and a new equilibrium per contact");
    }

    void addBolts() {
        add(counts_.bolts == 0, "bolts", "the scene has none", "three unknowns per node");
        if (counts_.bolts == 0) return;
        int straight = 0, noHinge = 0, noRupture = 0, pulledOnly = 0, pullTests = 0;
        for (std::size_t i = 0; i < model_.bolts.size(); ++i) {
            const BoltModel& bolt = model_.bolts[i];
            const int elements = static_cast<int>(bolt.elements.size());
            straight += bolt.bends ? 0 : elements + 1;
            noHinge += bolt.bends && !bolt.hinges ? elements : 0;
            noRupture += bolt.steel ? 0 : elements;
            if (scene_.bolts[i].divisions || !bolt.bends) continue;
            pulledOnly += bolt.joints.empty() ? 1 : 0;
            pullTests += bolt.joints.empty() || bolt.shears ? 0 : 1;
        }
        add(straight > 0, "rotation of bolt nodes", "their type has \"bending\": \"none\"", counted(straight, "unknown"));
        add(noHinge > 0, "plastic hinges", "\"bending\" is not \"elastic-plastic\", or no 'steel' is given",
            counted(2 * noHinge, "limit") + " to be checked");
        add(noRupture > 0, "yield and rupture of the shank", "the type has no 'steel'",
            counted(2 * noRupture, "limit") + " to be checked");
        add(pulledOnly > 0, "fine elements", "no joint crosses " + counted(pulledOnly, "bolt"),
            "elements of at most an eighth of the bending length of a dowel");
        add(pullTests > 0, "fine elements at joints", "the scene is a pull test of its bolt, without shear",
            "elements of at most an eighth of the bending length of a dowel");
        const int artificial = counts_.nodes - counts_.realAnchors;
        add(artificial > 0, "bond along the bolt at intermediate nodes (artificial anchors)",
            "the bolt type bonds other nodes", counted(artificial, "spring"));
        const auto crushes = [](const JointModel& joint) { return joint.crushingStrength.has_value(); };
        add(std::none_of(model_.joints.begin(), model_.joints.end(), crushes), "crushing of rock under bolts",
            "no joint material has a 'crushing_strength'", counted(counts_.nodes, "limit") + " to be checked");
        addPlates();
    }

    void addPlates() {
        int springs = 0, none = 0;
        for (const Bolt& bolt : scene_.bolts) {
            springs += bolt.plate == PlateKind::Spring ? 1 : 0;
            none += bolt.plate == PlateKind::None ? 1 : 0;
        }
        add(springs > 0, "plates as blocks", "their 'plate' is \"spring\"",
            counted(6 * springs, "unknown") + " and the contacts under them");
        add(none > 0, "plates", "'plate' is \"none\"", counted(2 * none, "spring"));
    }

    void addStages() {
        const auto some = [&](const auto& question) {
            return std::any_of(scene_.stages.begin(), scene_.stages.end(), question);
        };
        const bool moves = some([](const Stage& s) { return s.kind == StageKind::Dynamic; });
        const bool rests = some([](const Stage& s) { return s.kind == StageKind::Static; });
        add(rests && !moves, "motion over time", "every stage is static", "time steps; velocities are not saved");
        add(moves && sleepTolerance(scene_) > 0.0, "motion of blocks at rest (sleep)",
            "a block whose unbalanced force stays below " + rounded(sleepTolerance(scene_)) +
                " of its weight ('sleep_tolerance') rests until something around it moves",
            "its six unknowns and its contacts while it sleeps; 'info' reports the share of the blocks that were awake");
        add(moves && !rests, "searches for equilibrium", "every stage is dynamic",
            "the search between two failures");
        add(moves && scene_.analysis.damping == Damping{}, "damping", "'damping' is zero",
            "a term per body and a link per element");
        add(moves && !some([](const Stage& s) { return !s.viscousBoundaries.empty(); }), "non-reflecting sides",
            "no stage names 'viscous_boundaries'", "four dashpots per face");
        add(!some([](const Stage& s) { return !s.dilations.empty(); }), "opening of joints",
            "no stage has 'dilations'", "an offset of the gap of every contact");
    }

    /// Number of unknowns prescribed by the motions of all stages; each block counts once.
    int prescribed() const {
        std::vector<char> way(scene_.blocks.size(), 0), turn(scene_.blocks.size(), 0);
        for (const Stage& stage : scene_.stages)
            for (const Motion& motion : stage.motions) {
                const int block = blockAt(scene_, motion.blockAt);
                if (block < 0) continue;
                way[block] = 1;
                if (motion.rotation == Rotation::Held) turn[block] = 1;
            }
        return static_cast<int>(std::count(way.begin(), way.end(), 1) + std::count(turn.begin(), turn.end(), 1));
    }

    const Scene& scene_;
    const Model& model_;
    const ModelCounts& counts_;
    std::vector<LeftOut> list_;
};

}  // namespace

std::vector<LeftOut> leftOutOf(const Scene& scene, const SceneCut* cut, const Model& model,
                               const ModelCounts& counts) {
    return LeftOutList(scene, model, counts).make(cut);
}

}  // namespace keyblock
