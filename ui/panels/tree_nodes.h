// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the scene tree as plain values. The children of long lists are created
// when the list is opened.
#pragma once

#include "solver/scene/problem.h"

#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

class Display;
class Document;

struct TreeNode {
    QString id;  // pointer of an object or a list; `#…` for other rows
    QString name, detail, icon;
    bool isObject = false;  // `id` is the pointer of an object that can be selected
    bool hasPlace = false;  // it can be zoomed to
    bool canHide = false;  // in the section
    bool canRename = false;
    bool canMove = false;  // by dragging, within its list
    bool takesDrops = false;  // a list whose entries can be moved
    bool bold = false;
    std::optional<Severity> badge;
    int waiting = 0;  // children that are created on demand
    TreeNode* parent = nullptr;
    int row = 0;  // among its parent's children
    std::vector<std::unique_ptr<TreeNode>> children;
};

/// A run in the list of results.
struct RunRow {
    QString id, name, detail, icon;
    bool current = false;
};

/// Input of the tree.
struct TreeSource {
    const Document& document;
    const Display& display;
    const std::vector<RunRow>& runs;
    QString filter;  // shows rows with this text and their parents; all lists are open
};

/// The whole tree; its root is not shown.
std::unique_ptr<TreeNode> makeTree(const TreeSource& source);

/// Appends the child.
TreeNode& addChild(TreeNode& parent, std::unique_ptr<TreeNode> child);

/// The deferred children of `node`.
std::vector<std::unique_ptr<TreeNode>> waitingChildren(const TreeSource& source, const TreeNode& node);

/// The highest severity of the messages on each pointer and on its parents.
std::map<std::string, Severity> severities(const std::vector<Problem>& problems);

}  // namespace keyblock
