// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the scene tree as plain values. The children of long lists are created
// only when the list is expanded.
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
    QString id;  // pointer to an object or a list; `#…` for other rows
    QString name, detail, icon;
    bool isObject = false;  // `id` is the pointer of an object that can be selected
    bool hasPlace = false;  // the view can zoom to it
    bool canHide = false;  // can be hidden in the section
    bool canRename = false;
    bool canMove = false;  // can be dragged within its list
    bool takesDrops = false;  // is a list whose entries can be moved by dragging
    bool bold = false;
    std::optional<Severity> badge;
    int waiting = 0;  // number of children that are created on demand
    TreeNode* parent = nullptr;
    int row = 0;  // index among the children of `parent`
    std::vector<std::unique_ptr<TreeNode>> children;
};

/// A run in the list of results.
struct RunRow {
    QString id, name, detail, icon;
    bool current = false;
};

/// Data from which the tree is built.
struct TreeSource {
    const Document& document;
    const Display& display;
    const std::vector<RunRow>& runs;
    QString filter;  // only rows that contain this text and their parents are shown, with all lists expanded
};

/// The whole tree. Its root node is not shown.
std::unique_ptr<TreeNode> makeTree(const TreeSource& source);

/// Appends a child and returns it.
TreeNode& addChild(TreeNode& parent, std::unique_ptr<TreeNode> child);

/// Creates the deferred children of `node`.
std::vector<std::unique_ptr<TreeNode>> waitingChildren(const TreeSource& source, const TreeNode& node);

/// Maps a JSON pointer to the highest severity of the errors and warnings about the value at this pointer or about
/// anything below it. Pointers without problems are left out.
std::map<std::string, Severity> severities(const std::vector<Problem>& problems);

}  // namespace keyblock
