// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/journal_text.h"

#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/sha256.h"

#include <utility>

namespace keyblock {

namespace {

constexpr std::size_t hashDigits = 16;
constexpr double journalVersion = 1.0;

std::string lineOf(JsonObject members) {
    const std::string body = jsonLine({std::move(members)});
    return sha256(body).substr(0, hashDigits) + " " + body + "\n";
}

JsonNode numberNode(std::size_t number) { return {static_cast<double>(number)}; }

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

std::optional<std::size_t> countOf(const JsonNode& node) {
    const auto* number = std::get_if<double>(&node.value);
    if (!number || *number < 0.0 || *number > 1e15) return {};
    return *number;
}

std::optional<std::size_t> countAt(const JsonNode& node, std::string_view key) {
    const JsonNode* member = findMember(node, key);
    return member ? countOf(*member) : std::nullopt;
}

JournalStep wholeStep(std::string name, std::string text) {
    const std::size_t size = text.size();
    return {std::move(name), true, {{0, 0, std::move(text)}}, size};
}

bool begin(Journalled& journal, const JsonNode& body) {
    if (countAt(body, "journal") != static_cast<std::size_t>(journalVersion)) return false;
    journal.path = textAt(body, "path");
    journal.name = textAt(body, "name");
    if (countAt(body, "saved")) journal.saved = 0;
    journal.steps.push_back(wholeStep({}, textAt(body, "scene")));
    return true;
}

std::optional<TextChange> changeOf(const JsonNode& node) {
    const auto* parts = std::get_if<JsonList>(&node.value);
    if (!parts || parts->size() != 3) return {};
    const std::optional<std::size_t> begin = countOf((*parts)[0]), removed = countOf((*parts)[1]);
    const auto* text = std::get_if<std::string>(&(*parts)[2].value);
    if (!begin || !removed || !text) return {};
    return TextChange{*begin, *removed, *text};
}

/// Older journals have one change per line. It is given by the lengths of the unchanged text at both ends.
std::optional<std::vector<TextChange>> changesAt(const JsonNode& body, std::size_t before) {
    const JsonNode* member = findMember(body, "changes");
    if (!member) {
        const auto begin = countAt(body, "begin"), end = countAt(body, "end");
        if (!begin || !end || *begin + *end > before) return {};
        return std::vector{TextChange{*begin, before - *begin - *end, textAt(body, "text")}};
    }
    const auto* list = std::get_if<JsonList>(&member->value);
    if (!list) return {};
    std::vector<TextChange> changes;
    for (const JsonNode& node : *list) {
        std::optional<TextChange> change = changeOf(node);
        if (!change) return {};
        changes.push_back(std::move(*change));
    }
    if (!areWithin(changes, before)) return {};
    return changes;
}

bool applyStep(Journalled& journal, const JsonNode& body, std::size_t index) {
    if (index == 0 || index > journal.steps.size()) return false;
    JournalStep step;
    if (findMember(body, "scene")) {
        step = wholeStep(textAt(body, "step"), textAt(body, "scene"));
    } else {
        const std::size_t before = journal.steps[index - 1].size;
        std::optional<std::vector<TextChange>> changes = changesAt(body, before);
        if (!changes) return false;
        step = {textAt(body, "step"), false, std::move(*changes), before};
        for (const TextChange& change : step.changes) step.size += change.text.size();
        for (const TextChange& change : step.changes) step.size -= change.removed;
    }
    journal.steps.resize(index);
    if (journal.saved && *journal.saved >= index) journal.saved.reset();
    journal.steps.push_back(std::move(step));
    journal.index = index;
    return true;
}

bool applySaved(Journalled& journal, const JsonNode& body) {
    const auto saved = countAt(body, "at");
    if (saved && *saved >= journal.steps.size()) return false;
    journal.saved = saved;
    journal.path = textAt(body, "saved");
    return true;
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
    JsonList changes;
    for (TextChange& change : textChanges(before, after))
        changes.push_back({JsonList{numberNode(change.begin), numberNode(change.removed), {std::move(change.text)}}});
    return lineOf({{"at", numberNode(index)}, {"step", {name}}, {"changes", {std::move(changes)}}});
}

std::string journalWholeStep(std::size_t index, const std::string& name, const std::string& after) {
    return lineOf({{"at", numberNode(index)}, {"step", {name}}, {"scene", {after}}});
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
            journal.damage =
                "line " + std::to_string(line) + " is damaged; the edits before it can be recovered";
            break;
        }
        text.remove_prefix(end + 1);
        journal.size += end + 1;
    }
    return journal;
}

std::string textAfter(const JournalStep& step, std::string_view before) {
    return changed(step.isWhole ? std::string_view() : before, step.changes);
}

}  // namespace keyblock
