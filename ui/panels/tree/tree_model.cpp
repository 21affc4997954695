// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/tree/tree_model.h"

#include "ui/look/plain_text.h"

#include <QMimeData>

namespace keyblock {

namespace {

const QString draggedType = QStringLiteral("application/x-keyblock-row");

/// Whether two trees have the same rows. A long list that was opened is equal to a list that is still to be filled if
/// both have the same number of rows.
bool sameRows(const TreeNode& a, const TreeNode& b) {
    if (a.id != b.id) return false;
    if (b.waiting > 0) return a.waiting == b.waiting || static_cast<int>(a.children.size()) == b.waiting;
    if (a.waiting != 0 || a.children.size() != b.children.size()) return false;
    for (std::size_t i = 0; i < a.children.size(); ++i)
        if (!sameRows(*a.children[i], *b.children[i])) return false;
    return true;
}

void takeTexts(TreeNode& node, TreeNode& from, const TreeModel::Fetch& fetch) {
    if (from.waiting > 0 && node.waiting == 0)
        for (auto& child : fetch(from)) addChild(from, std::move(child));
    std::swap(node.name, from.name);
    std::swap(node.detail, from.detail);
    node.icon = from.icon;
    node.badge = from.badge;
    node.bold = from.bold;
    node.canHide = from.canHide;
    for (std::size_t i = 0; i < node.children.size(); ++i) takeTexts(*node.children[i], *from.children[i], fetch);
}

}  // namespace

TreeModel::TreeModel(QObject* parent) : QAbstractItemModel(parent), root_(std::make_unique<TreeNode>()) {}

bool TreeModel::show(std::unique_ptr<TreeNode> root) {
    if (sameRows(*root_, *root)) {
        takeTexts(*root_, *root, fetch_);
        Q_EMIT layoutChanged();
        return false;
    }
    beginResetModel();
    root_ = std::move(root);
    nodes_.clear();
    list(*root_);
    endResetModel();
    return true;
}

void TreeModel::list(const TreeNode& node) {
    for (const auto& child : node.children) {
        nodes_.insert(child->id, child.get());
        list(*child);
    }
}

TreeNode* TreeModel::nodeOf(const QModelIndex& index) const {
    return index.isValid() ? static_cast<TreeNode*>(index.internalPointer()) : root_.get();
}

const TreeNode& TreeModel::nodeAt(const QModelIndex& index) const { return *nodeOf(index); }

QModelIndex TreeModel::indexOfNode(const TreeNode& node) const {
    return &node == root_.get() ? QModelIndex() : createIndex(node.row, 0, const_cast<TreeNode*>(&node));
}

QModelIndex TreeModel::indexOf(const QString& id) const {
    const TreeNode* node = nodes_.value(id);
    return node ? indexOfNode(*node) : QModelIndex();
}

QModelIndex TreeModel::index(int row, int column, const QModelIndex& parent) const {
    const TreeNode* node = nodeOf(parent);
    if (row < 0 || row >= static_cast<int>(node->children.size()) || column != 0) return {};
    return createIndex(row, 0, node->children[row].get());
}

QModelIndex TreeModel::parent(const QModelIndex& index) const {
    const TreeNode* node = nodeOf(index);
    return node->parent ? indexOfNode(*node->parent) : QModelIndex();
}

int TreeModel::rowCount(const QModelIndex& parent) const { return static_cast<int>(nodeOf(parent)->children.size()); }

bool TreeModel::hasChildren(const QModelIndex& parent) const {
    const TreeNode* node = nodeOf(parent);
    return node->waiting > 0 || !node->children.empty();
}

bool TreeModel::canFetchMore(const QModelIndex& parent) const { return nodeOf(parent)->waiting > 0; }

void TreeModel::fetchMore(const QModelIndex& parent) {
    TreeNode* node = nodeOf(parent);
    if (node->waiting == 0 || !fetch_) return;
    auto made = fetch_(*node);
    node->waiting = 0;
    if (made.empty()) return;
    beginInsertRows(parent, 0, static_cast<int>(made.size()) - 1);
    for (auto& child : made) addChild(*node, std::move(child));
    list(*node);
    endInsertRows();
}

QVariant TreeModel::data(const QModelIndex& index, int role) const {
    const TreeNode& node = nodeAt(index);
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole: return node.name;
        case Qt::ToolTipRole: return asTip(node.detail.isEmpty() ? node.name : node.name + "\n" + node.detail);
        case Qt::AccessibleTextRole: return node.name + ' ' + node.detail;
        default: return {};
    }
}

bool TreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const TreeNode& node = nodeAt(index);
    const QString name = value.toString().trimmed();
    if (role != Qt::EditRole || !node.canRename || !rename_ || name.isEmpty() || name == node.name) return false;
    rename_(node.id, name);
    return true;
}

Qt::ItemFlags TreeModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    const TreeNode& node = nodeAt(index);
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (node.canRename) flags |= Qt::ItemIsEditable;
    if (node.canMove) flags |= Qt::ItemIsDragEnabled;
    if (node.takesDrops) flags |= Qt::ItemIsDropEnabled;
    return flags;
}

QStringList TreeModel::mimeTypes() const { return {draggedType}; }

QMimeData* TreeModel::mimeData(const QModelIndexList& indexes) const {
    auto* dragged = new QMimeData;
    if (!indexes.isEmpty()) dragged->setData(draggedType, nodeAt(indexes.front()).id.toUtf8());
    return dragged;
}

bool TreeModel::canDropMimeData(const QMimeData* dragged, Qt::DropAction, int row, int,
                                const QModelIndex& parent) const {
    return dragged->hasFormat(draggedType) && row >= 0 && nodeAt(parent).takesDrops;
}

/// Moves the row to the drop position, so the view must not remove the old row.
bool TreeModel::dropMimeData(const QMimeData* dragged, Qt::DropAction action, int row, int column,
                             const QModelIndex& parent) {
    if (!canDropMimeData(dragged, action, row, column, parent) || !move_) return false;
    const QString pointer = QString::fromUtf8(dragged->data(draggedType));
    const int from = pointer.section('/', -1).toInt();
    move_(pointer, row > from ? row - 1 : row);
    return false;
}

}  // namespace keyblock
