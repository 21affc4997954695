// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/journal_text.h"

#include "solver/files/json_text.h"
#include "solver/files/json_tree.h"
#include "solver/files/sha256.h"

#include <algorithm>

namespace keyblock {

namespace {

constexpr std::size_t hashDigits = 16;
constexpr double journalVersion = 1.0;

std::string lineOf(JsonObject members) {
    const std::string body = jsonLine({std::move(members)});
    return sha256(body).substr(0, hashDigits) + " " + body + "\n";
}

JsonNode numberNode(std::size_t number) { return {static_cast<double>(number)}; }

bool isWithinLetter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Bytes at the beginning of both that are the same, whole letters of UTF-8 only.
std::size_t commonBegin(std::string_view a, std::string_view b) {
    const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    auto same = static_cast<std::size_t>(differ.first - a.begin());
    while (same > 0 && ((same < a.size() && isWithinLetter(a[same])) || (same < b.size() && isWithinLetter(b[same]))))
        --same;
    return same;
}

std::size_t commonEnd(std::string_view a, std::string_view b) {
    const auto differ = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    auto same = static_cast<std::size_t>(differ.first - a.rbegin());
    while (same > 0 && isWithinLetter(a[a.size() - same])) --same;
    return same;
}

std::optional<JsonNode> bodyOf(std::string_view line) {
    if (line.size() <= hashDigits + 1 || line[hashDigits] != ' ') return {};
    const std::string_view body = line.substr(hashDigits + 1);
    if (sha256(body).substr(0, hashDigits) != line.substr(0, hashDigits)) return {};
    return readJson(body).root;
}

std::string textAt(const JsonNode& node, std::string_view key) {
    const JsonNode* member = findMember(node, key);
    const auto* text = member ? std::get_if<std::string>(&member->value) : nullptr;
    return text ? *text : std::string();
}

std::optional<std::size_t> countAt(const JsonNode& node, std::string_view key) {
    const JsonNode* member = findMember(node, key);
    const auto* number = member ? std::get_if<double>(&member->value) : nullptr;
    if (!number || *number < 0.0 || *number > 1e15) return {};
    return static_cast<std::size_t>(*number);
}

bool begin(Journalled& journal, const JsonNode& body) {
    if (countAt(body, "journal") != static_cast<std::size_t>(journalVersion)) return false;
    journal.path = textAt(body, "path");
    journal.name = textAt(body, "name");
    if (countAt(body, "saved")) journal.saved = 0;
    journal.steps.push_back({{}, textAt(body, "scene")});
    return true;
}

bool applyStep(Journalled& journal, const JsonNode& body, std::size_t index) {
    const auto begin = countAt(body, "begin");
    const auto end = countAt(body, "end");
    if (index == 0 || index > journal.steps.size() || !begin || !end) return false;
    const std::string& before = journal.steps[index - 1].text;
    if (*begin + *end > before.size()) return false;
    std::string after = before.substr(0, *begin) + textAt(body, "text") + before.substr(before.size() - *end);
    journal.steps.resize(index);
    if (journal.saved && *journal.saved >= index) journal.saved.reset();
    journal.steps.push_back({textAt(body, "step"), std::move(after)});
    journal.index = index;
    return true;
}

bool applySaved(Journalled& journal, const JsonNode& body) {
    journal.saved = countAt(body, "at");
    journal.path = textAt(body, "saved");
    return !journal.saved || *journal.saved < journal.steps.size();
}

bool apply(Journalled& journal, const JsonNode& body) {
    if (journal.steps.empty()) return begin(journal, body);
    if (findMember(body, "saved")) return applySaved(journal, body);
    const auto index = countAt(body, "at");
    if (!index) return false;
    if (findMember(body, "step")) {
        if (!applyStep(journal, body, *index)) return false;
    } else {
        if (*index >= journal.steps.size()) return false;
        journal.index = *index;
    }
    ++journal.changes;
    return true;
}

}  // namespace

std::string journalBegin(const std::string& path, const std::string& name, const std::string& sceneText, bool isSaved) {
    JsonObject members{{"journal", {journalVersion}}, {"path", {path}}, {"name", {name}}, {"scene", {sceneText}}};
    if (isSaved) members.push_back({"saved", {0.0}});
    return lineOf(std::move(members));
}

std::string journalStep(std::size_t index, const std::string& name, std::string_view before, std::string_view after) {
    const std::size_t begin = commonBegin(before, after);
    const std::size_t end = commonEnd(before.substr(begin), after.substr(begin));
    return lineOf({{"at", numberNode(index)},
                   {"step", {name}},
                   {"begin", numberNode(begin)},
                   {"end", numberNode(end)},
                   {"text", {std::string(after.substr(begin, after.size() - begin - end))}}});
}

std::string journalMove(std::size_t index) { return lineOf({{"at", numberNode(index)}}); }

std::string journalSaved(std::optional<std::size_t> index, const std::string& path) {
    return lineOf({{"at", index ? numberNode(*index) : JsonNode{}}, {"saved", {path}}});
}

Journalled readJournal(std::string_view text, std::optional<std::size_t> mostChanges) {
    Journalled journal;
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) break;
        const std::optional<JsonNode> body = bodyOf(text.substr(0, end));
        const bool isChange = body && findMember(*body, "at") && !findMember(*body, "saved");
        if (isChange && mostChanges && journal.changes >= *mostChanges) break;
        if (!body || !apply(journal, *body)) {
            journal.damage = "line " + std::to_string(line) + " of the journal is damaged; what stands before it is kept";
            break;
        }
        text.remove_prefix(end + 1);
    }
    return journal;
}

}  // namespace keyblock
