// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/tree/tree_nodes.h"

#include "solver/scene/field.h"
#include "solver/scene/pointer.h"
#include "ui/document/document.h"
#include "ui/edit/names.h"
#include "ui/look/display.h"
#include "ui/panels/fields/object_detail.h"
#include "ui/panels/fields/value_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int longList = 60;  // lists with more entries are filled only when they are opened

struct NodeTexts {
    Q_DECLARE_TR_FUNCTIONS(SceneTree)
};

using Children = std::vector<std::unique_ptr<TreeNode>>;

class Maker {
public:
    explicit Maker(const TreeSource& source)
        : source_(source), scene_(*source.document.scene()),
          severities_(severities(source.document.checked().problems)) {}

    std::unique_ptr<TreeNode> tree() {
        auto root = std::make_unique<TreeNode>();
        addGeometry(*root);
        addMaterials(*root);
        addList(*root, "/joint_sets", NodeTexts::tr("Joint sets"), "joint-set", true);
        addList(*root, "/joints", NodeTexts::tr("Joints"), "joint", true);
        addList(*root, "/tunnels", NodeTexts::tr("Tunnels"), "tunnel", false);
        addBolts(*root);
        addList(*root, "/supports", NodeTexts::tr("Supports"), "support", true);
        addLoads(*root);
        addList(*root, "/stages", NodeTexts::tr("Stages"), "stage", false);
        addList(*root, "/monitors", NodeTexts::tr("Monitors"), "monitor", true);
        addResults(*root);
        return root;
    }

    /// Rows for the entries of a list or a map.
    Children entries(const QString& list) {
        Children rows;
        const std::size_t count = countOf(list);
        for (std::size_t i = 0; i < count; ++i) {
            auto row = entry(pointerOf(list, i), list);
            if (!source_.filter.isEmpty() && !matches(*row)) continue;
            rows.push_back(std::move(row));
        }
        return rows;
    }

    std::size_t countOf(const QString& list) const { return rowOf(list).children.count(&scene_); }

private:
    bool matches(const TreeNode& node) const {
        return node.name.contains(source_.filter, Qt::CaseInsensitive) ||
               node.detail.contains(source_.filter, Qt::CaseInsensitive);
    }

    static const Field& rowOf(const QString& list) {
        return *findField(sceneStructure(), list.mid(1).toStdString());
    }

    std::string pointerOf(const QString& list, std::size_t index) const {
        const Field& row = rowOf(list);
        const std::string pointer = list.toStdString();
        return row.kind == FieldKind::Map ? under(pointer, row.children.name(&scene_, index)) : under(pointer, index);
    }

    std::optional<Severity> badgeAt(const std::string& pointer) const {
        const auto found = severities_.find(pointer);
        return found == severities_.end() ? std::nullopt : std::optional(found->second);
    }

    std::unique_ptr<TreeNode> entry(const std::string& pointer, const QString& list) const {
        auto node = std::make_unique<TreeNode>();
        node->id = QString::fromStdString(pointer);
        const std::string name = nameAt(scene_, pointer);
        node->name = QString::fromStdString(name.empty() ? titleAt(scene_, pointer) : name);
        node->detail = detailOf(source_.document, source_.display, pointer);
        node->icon = iconOf(source_.document, pointer);
        node->isObject = true;
        const Field* row = list.isEmpty() ? nullptr : &rowOf(list);
        node->hasPlace = !row || (row->kind == FieldKind::List && !row->isOrdered);
        node->canHide = node->hasPlace && list != "/tunnels";
        node->canRename = row && hasNames(*row);
        node->canMove = row && row->isOrdered;
        node->badge = badgeAt(pointer);
        return node;
    }

    std::unique_ptr<TreeNode> heading(const QString& id, const QString& name, const QString& icon, bool canHide) const {
        auto node = std::make_unique<TreeNode>();
        node->id = id;
        node->name = name;
        node->icon = icon;
        node->canHide = canHide;
        node->badge = badgeAt(id.toStdString());
        return node;
    }

    /// Adds the heading unless the filter matches neither the heading nor any of its rows.
    void addHeading(TreeNode& root, std::unique_ptr<TreeNode> node) {
        if (!source_.filter.isEmpty() && node->children.empty() && !matches(*node)) return;
        addChild(root, std::move(node));
    }

    void fill(TreeNode& node, const QString& list) {
        const std::size_t count = countOf(list);
        if (static_cast<int>(count) > longList && source_.filter.isEmpty()) {
            node.waiting = static_cast<int>(count);
            return;
        }
        for (auto& row : entries(list)) addChild(node, std::move(row));
    }

    void addList(TreeNode& root, const QString& list, const QString& name, const QString& icon, bool canHide) {
        const std::size_t count = countOf(list);
        auto node = heading(list, name, icon, canHide && count > 0);
        node->takesDrops = rowOf(list).isOrdered;
        node->detail = count > 0 ? Display::number(static_cast<double>(count), 12) : NodeTexts::tr("none");
        fill(*node, list);
        addHeading(root, std::move(node));
    }

    void addGeometry(TreeNode& root) {
        auto node = heading("#geometry", NodeTexts::tr("Geometry"), "outline", false);
        node->badge = worst({"/domain", "/regions", "/voronoi", "/blocks", "/cutting"});
        if (scene_.domain) addOne(*node, "/domain", NodeTexts::tr("Domain"), true);
        if (scene_.voronoi) addOne(*node, "/voronoi", NodeTexts::tr("Voronoi cells"));
        for (auto& row : entries("/regions")) addChild(*node, std::move(row));
        addBlocks(*node);
        addHeading(root, std::move(node));
    }

    /// Adds the blocks given in the scene; the heading shows the number of blocks after cutting.
    void addBlocks(TreeNode& geometry) {
        auto blocks = heading("/blocks", NodeTexts::tr("Blocks"), "block", true);
        const auto& cut = source_.document.checked().cut;
        const std::size_t all = cut ? cut->scene.blocks.size() : scene_.blocks.size();
        blocks->detail = Display::number(static_cast<double>(all), 12);
        if (all > scene_.blocks.size() && !scene_.blocks.empty())
            blocks->detail = NodeTexts::tr("%1 (%2 drawn)").arg(blocks->detail).arg(scene_.blocks.size());
        fill(*blocks, "/blocks");
        if (source_.filter.isEmpty() || matches(*blocks) || !blocks->children.empty())
            addChild(geometry, std::move(blocks));
    }

    void addOne(TreeNode& parent, const std::string& pointer, const QString& name, bool hasPlace = false) {
        auto node = entry(pointer, {});
        node->name = name;
        node->canHide = false;
        node->hasPlace = hasPlace;
        if (source_.filter.isEmpty() || matches(*node)) addChild(parent, std::move(node));
    }

    std::optional<Severity> worst(std::initializer_list<std::string> pointers) const {
        std::optional<Severity> worst;
        for (const std::string& pointer : pointers)
            if (const auto badge = badgeAt(pointer); badge && (!worst || *badge < *worst)) worst = badge;
        return worst;
    }

    void addMaterials(TreeNode& root) {
        auto node = heading("#materials", NodeTexts::tr("Materials"), "material", false);
        node->badge = worst({"/materials", "/joint_materials"});
        for (auto& row : entries("/materials")) addChild(*node, std::move(row));
        for (auto& row : entries("/joint_materials")) addChild(*node, std::move(row));
        node->detail = node->children.empty() ? NodeTexts::tr("none") : QString::number(node->children.size());
        addHeading(root, std::move(node));
    }

    void addBolts(TreeNode& root) {
        auto node = heading("/bolts", NodeTexts::tr("Bolts"), "bolt", !scene_.bolts.empty() || !scene_.boltPatterns.empty());
        node->badge = worst({"/bolts", "/bolt_patterns", "/bolt_types"});
        const auto& cut = source_.document.checked().cut;
        const std::size_t all = cut ? cut->scene.bolts.size() : scene_.bolts.size();
        node->detail = all > 0 ? Display::number(static_cast<double>(all), 12) : NodeTexts::tr("none");
        for (auto& row : entries("/bolt_patterns")) addChild(*node, std::move(row));
        if (scene_.bolts.size() > static_cast<std::size_t>(longList) && source_.filter.isEmpty()) {
            auto single = heading("/bolts/", NodeTexts::tr("Single bolts"), "bolt", false);
            single->detail = QString::number(scene_.bolts.size());
            single->waiting = static_cast<int>(scene_.bolts.size());
            addChild(*node, std::move(single));
        } else {
            for (auto& row : entries("/bolts")) addChild(*node, std::move(row));
        }
        for (const BoltType& type : scene_.boltTypes)
            if (!type.builtIn) {
                auto row = entry(under("/bolt_types", type.name), "/bolt_types");
                if (source_.filter.isEmpty() || matches(*row)) addChild(*node, std::move(row));
            }
        addHeading(root, std::move(node));
    }

    QString gravityText() const {
        return numberText(scene_.analysis.gravity.norm(), "m/s²", source_.display, 4) + QString::fromUtf8(" m/s²");
    }

    void addLoads(TreeNode& root) {
        auto node = heading("#loads", NodeTexts::tr("Loads"), "load", false);
        addOne(*node, "/analysis", NodeTexts::tr("Gravity"));
        if (!node->children.empty()) {
            node->children.back()->detail = gravityText();
            node->children.back()->icon = "arrow";
        }
        if (scene_.inSituStress) addOne(*node, "/in_situ_stress", NodeTexts::tr("In-situ stress"));
        for (std::size_t stage = 0; stage < scene_.stages.size(); ++stage) {
            const Stage& held = scene_.stages[stage];
            addOfStage(*node, stage, "loads", held.loads.size(), NodeTexts::tr("Load %1"), "load");
            addOfStage(*node, stage, "motions", held.motions.size(), NodeTexts::tr("Motion %1"), "motion");
        }
        node->detail = scene_.analysis.gravity.isZero() ? NodeTexts::tr("no gravity") : NodeTexts::tr("gravity");
        if (scene_.inSituStress)
            node->detail += ", " + detailOf(source_.document, source_.display, "/in_situ_stress");
        addHeading(root, std::move(node));
    }

    void addOfStage(TreeNode& node, std::size_t stage, std::string_view list, std::size_t count, const QString& title,
                    const QString& icon) {
        const QString stageName = QString::fromStdString(scene_.stages[stage].name);
        for (std::size_t i = 0; i < count; ++i) {
            auto row = entry(under(under(under("/stages", stage), list), i), {});
            row->name = title.arg(i + 1);
            row->detail = (row->detail + ' ' + NodeTexts::tr("in %1").arg(stageName)).trimmed();
            row->icon = icon;
            row->canHide = true;
            if (source_.filter.isEmpty() || matches(*row)) addChild(node, std::move(row));
        }
    }

    void addResults(TreeNode& root) {
        auto node = heading("#results", NodeTexts::tr("Results"), "result", false);
        node->detail = source_.runs.empty() ? NodeTexts::tr("no runs yet") : QString();
        for (const RunRow& run : source_.runs) {
            auto row = heading("#run/" + run.id, run.name, run.icon.isEmpty() ? "result" : run.icon, false);
            row->detail = run.detail;
            row->bold = run.current;
            if (source_.filter.isEmpty() || matches(*row)) addChild(*node, std::move(row));
        }
        addHeading(root, std::move(node));
    }

    const TreeSource& source_;
    const Scene& scene_;
    const std::map<std::string, Severity> severities_;
};

}  // namespace

TreeNode& addChild(TreeNode& parent, std::unique_ptr<TreeNode> child) {
    child->parent = &parent;
    child->row = static_cast<int>(parent.children.size());
    parent.children.push_back(std::move(child));
    return *parent.children.back();
}

std::unique_ptr<TreeNode> makeTree(const TreeSource& source) { return Maker(source).tree(); }

std::vector<std::unique_ptr<TreeNode>> waitingChildren(const TreeSource& source, const TreeNode& node) {
    Maker maker(source);
    const QString list = node.id.endsWith('/') ? node.id.chopped(1) : node.id;
    return maker.entries(list);
}

std::map<std::string, Severity> severities(const std::vector<Problem>& problems) {
    std::map<std::string, Severity> worst;
    for (const Problem& problem : problems) {
        if (problem.severity == Severity::Note) continue;
        for (std::string pointer = problem.pointer; !pointer.empty(); pointer = pointer.substr(0, pointer.rfind('/'))) {
            const auto [at, fresh] = worst.emplace(pointer, problem.severity);
            if (!fresh) at->second = std::min(at->second, problem.severity);
        }
    }
    return worst;
}

}  // namespace keyblock
