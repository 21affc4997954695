// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What goes must be there, and what comes must not: names of blocks and bolts
// that stages take out, install and remove, in the order of the stages.
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/presence.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <map>

namespace keyblock {

namespace {

/// Of tunnels and of blocks.
std::vector<std::string> blockNames(const Scene& scene) {
    std::vector<std::string> names;
    for (const SceneTunnel& tunnel : scene.tunnels)
        names.push_back(tunnel.name);
    for (int block = 0; block < static_cast<int>(scene.blocks.size()); ++block)
        names.push_back(displayName(scene, block));
    return names;
}

/// Of patterns and of bolts.
std::vector<std::string> boltNames(const Scene& scene) {
    std::vector<std::string> names;
    for (const ScenePattern& pattern : scene.boltPatterns)
        names.push_back(pattern.name);
    for (const Bolt& bolt : scene.bolts)
        names.push_back(bolt.name);
    return names;
}

/// Follows one list of names over the stages.
class Names {
public:
    Names(std::string_view what, std::vector<std::string> known, CheckReport& report)
        : what_(what), known_(std::move(known)), report_(report) {}

    /// \return false where there is no such thing, which is told.
    bool exists(const std::string& name, const std::string& pointer) {
        if (std::find(known_.begin(), known_.end(), name) != known_.end())
            return true;
        const std::vector<std::string_view> views(known_.begin(), known_.end());
        report_.error(pointer, "there is no " + what_ + " " + inQuotes(name), suggestion(name, views));
        return false;
    }

    /// Tells of the second time. \param done what happens to it, as `is excavated`.
    void once(const std::string& name, const std::string& stage, std::string_view done, const std::string& pointer) {
        const auto [first, isNew] = stages_.try_emplace(name, stage);
        if (!isNew)
            report_.error(pointer,
                          "the " + what_ + " " + inQuotes(name) + " " + std::string(done) + " in the stage " +
                              inQuotes(first->second) + " already",
                          "Name it once");
    }

    bool has(const std::string& name) const { return stages_.contains(name); }

private:
    std::string what_;
    std::vector<std::string> known_;
    std::map<std::string, std::string> stages_;  // by name
    CheckReport& report_;
};

void checkRelaxation(const Stage& stage, bool anyBefore, const std::string& pointer, CheckReport& report) {
    if (stage.relaxation && stage.excavate.empty() && !anyBefore)
        report.warning(under(pointer, "relaxation"), "nothing was excavated, so there is nothing to release",
                       "Excavate something in this stage or before it, or leave it out");
}

}  // namespace

void checkPresence(CheckContext& context) {
    if (!context.isCut)
        return;  // not all names are known
    const Scene& scene = context.scene;
    Names excavated("tunnel or block", blockNames(scene), context.report), installed("bolt", boltNames(scene), context.report),
        removed("bolt", boltNames(scene), context.report);
    const auto removeOnce = [&](const Bolt& bolt, const std::string& name, const Stage& stage, const std::string& at) {
        if (isInstalledLater(scene, bolt) && !installed.has(bolt.name))
            context.report.error(at, "the bolt " + inQuotes(name) + " is not installed yet",
                                 "Remove it in a later stage than the one that installs it");
        removed.once(bolt.name, stage.name, "is removed", at);
    };
    bool any = false;
    for (std::size_t i = 0; i < scene.stages.size(); ++i) {
        const Stage& stage = scene.stages[i];
        const std::string pointer = under("/stages", i);
        const auto each = [&](const std::vector<std::string>& names, const std::string& key, const auto& check) {
            for (std::size_t n = 0; n < names.size(); ++n)
                check(names[n], under(under(pointer, key), n));
        };
        each(stage.excavate, "excavate", [&](const std::string& name, const std::string& at) {
            if (!excavated.exists(name, at))
                return;
            excavated.once(name, stage.name, "is excavated", at);
            Stage alone;
            alone.excavate = {name};
            if (excavatedBlocks(scene, alone).empty())
                context.report.warning(at,
                                       "no block lies in the tunnel " + inQuotes(name) + ", so nothing is excavated",
                                       "Draw it larger or into the domain, or leave it out");
        });
        each(stage.remove, "remove", [&](const std::string& name, const std::string& at) {
            if (!removed.exists(name, at))
                return;
            for (int bolt : boltsNamed(scene, name))
                removeOnce(scene.bolts[static_cast<std::size_t>(bolt)], name, stage, at);
        });
        each(stage.install, "install", [&](const std::string& name, const std::string& at) {
            if (!installed.exists(name, at))
                return;
            for (int bolt : boltsNamed(scene, name))
                installed.once(scene.bolts[static_cast<std::size_t>(bolt)].name, stage.name, "is installed", at);
        });
        checkRelaxation(stage, any, pointer, context.report);
        any = any || !stage.excavate.empty();
    }
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
                             "Give a place in rock that is still there");
        return;
    }
}

}  // namespace keyblock
