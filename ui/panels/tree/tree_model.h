// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scene tree as a Qt model. If a new scene has the same rows, only their texts are
// updated; otherwise the tree is rebuilt, and the view expands the rows that were
// expanded before.
#pragma once

#include "ui/panels/tree/tree_nodes.h"

#include <QAbstractItemModel>
#include <QHash>

#include <functional>

namespace keyblock {

class TreeModel : public QAbstractItemModel {
    Q_OBJECT

public:
    using Fetch = std::function<std::vector<std::unique_ptr<TreeNode>>(const TreeNode&)>;
    using Rename = std::function<void(const QString& pointer, const QString& name)>;
    using Move = std::function<void(const QString& pointer, int to)>;

    explicit TreeModel(QObject* parent = nullptr);

    /// Shows this tree. Returns true if rows were added or removed.
    bool show(std::unique_ptr<TreeNode> root);

    /// Sets the function that creates the deferred children of a row.
    void setFetch(Fetch fetch) { fetch_ = std::move(fetch); }
    void setRename(Rename rename) { rename_ = std::move(rename); }
    void setMove(Move move) { move_ = std::move(move); }

    const TreeNode& nodeAt(const QModelIndex& index) const;

    /// The row with this id; an invalid index if there is no such row, or if the list that contains it has not been
    /// expanded yet.
    QModelIndex indexOf(const QString& id) const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return 1; }
    bool hasChildren(const QModelIndex& parent = {}) const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool canDropMimeData(const QMimeData* dragged, Qt::DropAction action, int row, int column,
                         const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* dragged, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

private:
    TreeNode* nodeOf(const QModelIndex& index) const;
    QModelIndex indexOfNode(const TreeNode& node) const;
    void list(const TreeNode& node);  // adds its children to `nodes_`

    std::unique_ptr<TreeNode> root_;
    QHash<QString, const TreeNode*> nodes_;  // by id
    Fetch fetch_;
    Rename rename_;
    Move move_;
};

}  // namespace keyblock
