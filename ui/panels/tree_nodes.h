// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the scene tree as plain values. Long lists stay a row with a count
// until somebody opens them.
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
    QString id;  // of its own kind: pointer of an object or a list, `#…` for the rest
    QString name, detail, icon;
    bool isObject = false;  // `id` is the pointer of something to select
    bool hasPlace = false;  // it can be zoomed to
    bool canHide = false;  // in the section
    bool canRename = false;
    bool canMove = false;  // by dragging, within its list
    bool bold = false;
    std::optional<Severity> badge;
    int waiting = 0;  // children that are made when asked for
    TreeNode* parent = nullptr;
    int row = 0;  // among its parent's children
    std::vector<std::unique_ptr<TreeNode>> children;
};

/// A run among the results, as the room of runs tells it.
struct RunRow {
    QString id, name, detail, icon;
    bool current = false;
};

/// What the tree is made from.
struct TreeSource {
    const Document& document;
    const Display& display;
    const std::vector<RunRow>& runs;
    QString filter;  // rows that hold this text, and those above them; all lists are open
};

/// The whole tree; its root is no row.
std::unique_ptr<TreeNode> makeTree(const TreeSource& source);

/// Puts the child behind the others.
TreeNode& addChild(TreeNode& parent, std::unique_ptr<TreeNode> child);

/// The children that wait in `node`.
std::vector<std::unique_ptr<TreeNode>> waitingChildren(const TreeSource& source, const TreeNode& node);

/// The worst that the check says of each pointer and of what holds it.
std::map<std::string, Severity> severities(const std::vector<Problem>& problems);

}  // namespace keyblock
