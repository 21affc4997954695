// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON as a small tree that remembers lines, because messages name where
// something is wrong. Duplicate keys are found, depth and size are limited, so
// that no text, however hostile, costs much.
#pragma once

#include "solver/scene/problem.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace keyblock {

struct JsonNode;
struct JsonMember;
using JsonList = std::vector<JsonNode>;
using JsonObject = std::vector<JsonMember>;  // in the order of the text, keys differ

/// One value: null, flag, number (always finite), text, list or object.
struct JsonNode {
    std::variant<std::monostate, bool, double, std::string, JsonList, JsonObject> value;
    int line = 0;  // where it begins, from 1; 0: not from a text
};

struct JsonMember {
    std::string key;
    JsonNode node;
};

/// What became of a text.
struct JsonReading {
    std::optional<JsonNode> root;  // none when the text is not JSON or beyond a limit
    std::vector<Problem> problems;  // the syntax error, or the duplicate keys, of which the first is kept
    std::optional<JsonNode> before{};  // where there is no root: what precedes the error
};

inline constexpr int deepestJson = 64;  // lists and objects inside each other
inline constexpr std::size_t longestJson = std::size_t{64} << 20;  // bytes
inline constexpr std::size_t mostJsonValues = 2'000'000;

/// Reads a JSON text in UTF-8. Problems have line and pointer but no file.
JsonReading readJson(std::string_view text);

/// The member of that key; null when there is none or `node` is not an object.
const JsonNode* findMember(const JsonNode& node, std::string_view key);

/// The value at the pointer; null where the tree has none.
const JsonNode* nodeAt(const JsonNode& root, std::string_view pointer);

/// Where the pointer leads, or as far as it leads: the line of the last value found.
int lineAt(const JsonNode& root, std::string_view pointer);

/// `null`, `true or false`, `a number`, `a text`, `a list` or `an object`.
std::string_view kindText(const JsonNode& node);

/// True when the bytes are UTF-8.
bool isUtf8(std::string_view text);

}  // namespace keyblock
