// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON as a small tree that keeps line numbers for error messages. Duplicate keys are
// reported. Depth and size are limited, so that even a malicious text takes little
// time and memory.
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
using JsonObject = std::vector<JsonMember>;  // in the order of the text, without duplicate keys

/// One value: null, Boolean, number (always finite), string, list or object.
struct JsonNode {
    std::variant<std::monostate, bool, double, std::string, JsonList, JsonObject> value;
    int line = 0;  // line on which the value begins, from 1; 0: not read from a text
};

struct JsonMember {
    std::string key;
    JsonNode node;
};

/// Result of reading JSON text.
struct JsonReading {
    std::optional<JsonNode> root;  // none if the text is not JSON or exceeds a limit
    std::vector<Problem> problems;  // a syntax error, a limit exceeded, or duplicate keys (the first of each is kept)
    std::optional<JsonNode> before{};  // if there is no root: the tree of the text before the error
};

inline constexpr int deepestJson = 64;  // nesting depth of lists and objects
inline constexpr std::size_t longestJson = std::size_t{64} << 20;  // bytes
inline constexpr std::size_t mostJsonValues = 2'000'000;

/// Reads JSON text encoded in UTF-8. The problems in the result have a line and a pointer, but no file name.
JsonReading readJson(std::string_view text);

/// The member with this key; null if there is none or if `node` is not an object.
const JsonNode* findMember(const JsonNode& node, std::string_view key);

/// The value at a JSON pointer; null if there is none.
const JsonNode* nodeAt(const JsonNode& root, std::string_view pointer);

/// Line of the value at a JSON pointer. If it does not exist, the line of the innermost existing value on the path.
int lineAt(const JsonNode& root, std::string_view pointer);

/// Type of a value as named in messages: `null`, `true or false`, `a number`, `a text`, `a list` or `an object`.
std::string_view kindText(const JsonNode& node);

/// Whether `text` is valid UTF-8.
bool isUtf8(std::string_view text);

}  // namespace keyblock
