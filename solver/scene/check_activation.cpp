// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks the blocks and bolts that stages excavate, install and remove, in the
// order of the stages: what is removed must be present, and what is installed
// must not be.
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/stage_objects.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <map>

namespace keyblock {

namespace {

/// Names of tunnels and blocks.
std::vector<std::string> blockNames(const Scene& scene) {
    std::vector<std::string> names;
    for (const SceneTunnel& tunnel : scene.tunnels)
        names.push_back(tunnel.name);
    for (int block = 0; block < static_cast<int>(scene.blocks.size()); ++block)
        names.push_back(displayName(scene, block));
    return names;
}

/// Names of bolt patterns and bolts.
std::vector<std::string> boltNames(const Scene& scene) {
    std::vector<std::string> names;
    for (const ScenePattern& pattern : scene.boltPatterns)
        names.push_back(pattern.name);
    for (const Bolt& bolt : scene.bolts)
        names.push_back(bolt.name);
    return names;
}

/// Tracks the names in one list across the stages.
class Names {
public:
    Names(std::string_view what, std::vector<std::string> known, CheckReport& report)
        : what_(what), known_(std::move(known)), report_(report) {}

    /// Reports a name that does not exist. \return whether it exists.
    bool exists(const std::string& name, const std::string& pointer) {
        if (std::find(known_.begin(), known_.end(), name) != known_.end())
            return true;
        if (report_.isFull()) return false;
        const std::vector<std::string_view> views(known_.begin(), known_.end());
        report_.error(pointer, "there is no " + what_ + " " + inQuotes(name), suggestion(name, views));
        return false;
    }

    /// Reports a name that is used a second time. \param done what happens to it, for example `is excavated`.
    void once(const std::string& name, const std::string& stage, std::string_view done, const std::string& pointer) {
        const auto [first, isNew] = stages_.try_emplace(name, stage);
        if (!isNew)
            tell(pointer,
                 "the " + what_ + " " + inQuotes(name) + " " + std::string(done) + " in the stage " +
                     inQuotes(first->second) + " already",
                 "Name it only once");
    }

    /// Reports an error, but only the first one at each pointer: the bolts of a pattern share a pointer.
    void tell(const std::string& pointer, const std::string& message, const std::string& remedy) {
        if (pointer != reported_) report_.error(pointer, message, remedy);
        reported_ = pointer;
    }

    bool has(const std::string& name) const { return stages_.contains(name); }

private:
    std::string what_;
    std::vector<std::string> known_;
    std::map<std::string, std::string> stages_;  // by name
    std::string reported_;  // pointer of the last error
    CheckReport& report_;
};

void checkRelaxation(const Stage& stage, bool anyBefore, const std::string& pointer, CheckReport& report) {
    if (stage.relaxation && stage.excavate.empty() && !anyBefore)
        report.warning(under(pointer, "relaxation"), "nothing was excavated, so there are no forces to release",
                       "Excavate something in this stage or before it, or omit the relaxation");
}

/// Tracks which parts are active, stage by stage.
class ActivationCheck {
public:
    explicit ActivationCheck(CheckContext& context)
        : context_(context), scene_(context.scene),
          excavated_("tunnel or block", blockNames(scene_), context.report),
          installed_("bolt", boltNames(scene_), context.report), removed_("bolt", boltNames(scene_), context.report),
          gone_(scene_.blocks.size(), false) {}

    void check(const Stage& stage, const std::string& pointer) {
        const auto each = [&](const std::vector<std::string>& names, const std::string& key, auto what) {
            for (std::size_t n = 0; n < names.size(); ++n)
                (this->*what)(names[n], stage, under(under(pointer, key), n));
        };
        each(stage.excavate, "excavate", &ActivationCheck::excavate);
        checkRockIsLeft(stage, pointer);
        each(stage.remove, "remove", &ActivationCheck::remove);
        each(stage.install, "install", &ActivationCheck::install);
        checkRelaxation(stage, any_, pointer, context_.report);
        any_ = any_ || !stage.excavate.empty();
    }

private:
    void excavate(const std::string& name, const Stage& stage, const std::string& at) {
        if (!excavated_.exists(name, at))
            return;
        excavated_.once(name, stage.name, "is excavated", at);
        Stage alone;
        alone.excavate = {name};
        const std::vector<int> blocks = excavatedBlocks(scene_, alone);
        for (int block : blocks)
            gone_[block] = true;
        if (blocks.empty())
            context_.report.warning(at,
                                    "no block lies in the tunnel " + inQuotes(name) + ", so nothing is excavated",
                                    "Make it larger, move it into the domain and out of open tunnels, or omit it");
    }

    void checkRockIsLeft(const Stage& stage, const std::string& pointer) {
        if (!stage.excavate.empty() && !gone_.empty() && std::find(gone_.begin(), gone_.end(), false) == gone_.end())
            context_.report.error(under(pointer, "excavate"), "no block is left after this stage",
                                  "Make the tunnel smaller, or the domain larger");
    }

    void remove(const std::string& name, const Stage& stage, const std::string& at) {
        if (!removed_.exists(name, at))
            return;
        for (int index : boltsNamed(scene_, name)) {
            const Bolt& bolt = scene_.bolts[index];
            if (isInstalledLater(scene_, bolt) && !installed_.has(bolt.name))
                removed_.tell(at, "the bolt " + inQuotes(name) + " is not installed yet",
                              "Remove it after the stage that installs it");
            removed_.once(bolt.name, stage.name, "is removed", at);
        }
    }

    void install(const std::string& name, const Stage& stage, const std::string& at) {
        if (!installed_.exists(name, at))
            return;
        for (int index : boltsNamed(scene_, name)) {
            const Bolt& bolt = scene_.bolts[index];
            installed_.once(bolt.name, stage.name, "is installed", at);
            if (context_.allSound() && runsThroughRock(bolt, context_, {}) && !runsThroughRock(bolt, context_, gone_))
                installed_.tell(at, "all rock that the bolt " + inQuotes(bolt.name) + " runs through is excavated "
                                                                                      "before this stage",
                                "Install it in an earlier stage, or place it in rock that is not excavated");
        }
    }

    CheckContext& context_;
    const Scene& scene_;
    Names excavated_, installed_, removed_;
    std::vector<bool> gone_;  // by block
    bool any_ = false;  // true if anything has been excavated so far
};

}  // namespace

void checkActivation(CheckContext& context) {
    if (!context.isCut)
        return;  // the names of cut blocks are not known yet
    ActivationCheck activation(context);
    for (std::size_t i = 0; i < context.scene.stages.size(); ++i)
        activation.check(context.scene.stages[i], under("/stages", i));
}

void checkStands(int block, std::size_t stage, const std::string& pointer, CheckContext& context) {
    if (block < 0)
        return;
    const Scene& scene = context.scene;
    for (std::size_t i = 0; i <= stage; ++i) {
        const std::vector<int> gone = excavatedBlocks(scene, scene.stages[i]);
        if (std::find(gone.begin(), gone.end(), block) == gone.end())
            continue;
        context.report.error(pointer,
                             "the block " + inQuotes(displayName(scene, block)) + " is excavated in the stage " +
                                 inQuotes(scene.stages[i].name),
                             "Give a point in rock that is still there");
        return;
    }
}

}  // namespace keyblock
