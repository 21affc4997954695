// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths can be written in three ways, all of which are converted to the same list of
// keys.
#include "solver/files/scene/overrides.h"

#include "solver/scene/suggest.h"

#include <charconv>

namespace keyblock {

namespace {

int lineOfOverride(std::size_t index) { return -1 - static_cast<int>(index); }

// Splits `a.b[2].c` or `a/b/2/c` at dots, slashes and brackets.
std::vector<std::string> keysOfWords(std::string_view path) {
    std::vector<std::string> keys(1);
    for (const char c : path) {
        if (c == ']')
            continue;
        if (c == '.' || c == '/' || c == '[')
            keys.emplace_back();
        else
            keys.back() += c;
    }
    return keys;
}

std::vector<std::string> keysOfPointer(std::string_view pointer) {
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/')
            keys.emplace_back();
        else if (pointer[i] == '~' && i + 1 < pointer.size())
            keys.back() += pointer[++i] == '1' ? '/' : '~';
        else
            keys.back() += pointer[i];
    }
    return keys;
}

void setLines(JsonNode& node, int line) {
    node.line = line;
    if (auto* list = std::get_if<JsonList>(&node.value))
        for (JsonNode& item : *list)
            setLines(item, line);
    if (auto* object = std::get_if<JsonObject>(&node.value))
        for (JsonMember& member : *object)
            setLines(member.node, line);
}

// The element of a list with this number or, if the key is not a number, with this name; null if there is none.
JsonNode* element(JsonList& list, const std::string& key) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    if (error == std::errc() && end == key.data() + key.size()) return index < list.size() ? &list[index] : nullptr;
    for (JsonNode& item : list) {
        const JsonNode* name = findMember(item, "name");
        const auto* text = name ? std::get_if<std::string>(&name->value) : nullptr;
        if (text && *text == key) return &item;
    }
    return nullptr;
}

// The member of an object, created if it is missing, or the element of a list; null if there is none.
JsonNode* child(JsonNode& node, const std::string& key) {
    if (auto* list = std::get_if<JsonList>(&node.value)) return element(*list, key);
    if (std::holds_alternative<std::monostate>(node.value))
        node.value = JsonObject{};
    auto* object = std::get_if<JsonObject>(&node.value);
    if (!object)
        return nullptr;
    if (const JsonNode* found = findMember(node, key))
        return const_cast<JsonNode*>(found);
    object->push_back({key, {}});
    return &object->back().node;
}

/// One option while it is applied to the tree.
class Override {
public:
    Override(const std::string& option, std::size_t index, std::vector<Problem>& problems)
        : option_(option), line_(lineOfOverride(index)), problems_(problems) {}

    void apply(JsonNode& root) {
        const auto equals = option_.find('=');
        if (!isUtf8(option_))
            return fail("the option is not UTF-8", "Write it in UTF-8");
        if (equals == std::string::npos || equals == 0)
            return fail("the option has no path or no value", "Write path=value, e.g. stages[0].increments=20");
        const std::string path = option_.substr(0, equals);
        const auto keys = keysOfPath(path);
        JsonNode* place = find(root, keys);
        if (!place)
            return;
        *place = value(option_.substr(equals + 1));
        setLines(*place, line_);
    }

private:
    JsonNode* find(JsonNode& root, const std::vector<std::string>& keys) {
        JsonNode* node = &root;
        for (const std::string& key : keys) {
            JsonNode* next = key.empty() ? nullptr : child(*node, key);
            if (!next) {
                fail(missing(*node, key), "Correct the path; list elements are given by number, from 0, or by name");
                return nullptr;
            }
            node = next;
        }
        return node;
    }

    static std::string missing(const JsonNode& node, const std::string& key) {
        if (key.empty())
            return "the path has an empty part";
        if (const auto* list = std::get_if<JsonList>(&node.value))
            return "there is no element " + inQuotes(key) + " in this list of " + std::to_string(list->size());
        return "there is no " + inQuotes(key) + " inside " + std::string(kindText(node));
    }

    // Reads JSON if the text is valid JSON, otherwise takes it as plain text: plate=none needs no quotes.
    JsonNode value(const std::string& text) {
        JsonReading reading = readJson(text);
        if (!reading.root)
            return {text};
        for (Problem& problem : reading.problems)
            fail(problem.message, problem.remedy);
        return std::move(*reading.root);
    }

    void fail(std::string message, std::string remedy) {
        addProblem(problems_, {Severity::Error, "", line_, "", std::move(message), std::move(remedy)});
    }

    const std::string& option_;
    int line_;
    std::vector<Problem>& problems_;
};

}  // namespace

std::vector<std::string> keysOfPath(std::string_view path) {
    return path.starts_with('/') ? keysOfPointer(path) : keysOfWords(path);
}

void applyOverrides(JsonNode& root, std::span<const std::string> overrides, std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < overrides.size(); ++i)
        Override(overrides[i], i, problems).apply(root);
}

void nameOrigins(std::vector<Problem>& problems, const std::string& file, std::span<const std::string> overrides) {
    for (Problem& problem : problems) {
        problem.file = file;
        if (problem.line >= 0)
            continue;
        problem.file = "--set " + overrides[-1 - problem.line];
        problem.line = 0;
    }
}

}  // namespace keyblock
