// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only place where a problem is formatted as a line of text.
#include "solver/scene/problem.h"

#include "solver/scene/suggest.h"
#include "solver/scene/visible_text.h"

#include <algorithm>
#include <utility>

namespace keyblock {

void addProblem(std::vector<Problem>& problems, Problem problem) {
    const bool isError = problem.severity == Severity::Error;
    if (problems.size() >= (isError ? mostProblems : mostProblems / 2))
        return;
    if (problems.size() + 1 == mostProblems) {
        problem.message = "there are more problems than are listed here";
        problem.remedy = "Correct these first";
    }
    problems.push_back(std::move(problem));
}

bool isFull(std::span<const Problem> problems) { return problems.size() >= mostProblems; }

bool hasErrors(std::span<const Problem> problems) {
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& problem) { return problem.severity == Severity::Error; });
}

std::string_view wordOf(Severity severity) {
    switch (severity) {
        case Severity::Error: return "error";
        case Severity::Warning: return "warning";
        case Severity::Note: return "note";
    }
    return {};
}

namespace {

/// The pointer with long keys shortened.
std::string shortPointer(std::string_view pointer) {
    std::string text;
    for (std::size_t from = 1; from <= pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', from), pointer.size());
        const std::string key = inQuotes(pointer.substr(from, end - from));
        text += "/" + key.substr(1, key.size() - 2);
        from = end + 1;
    }
    return text;
}

}  // namespace

std::string oneLine(const Problem& problem) {
    std::string text = problem.file;
    if (problem.line > 0)
        text += ":" + std::to_string(problem.line);
    text += text.empty() ? "" : ": ";
    text += std::string(wordOf(problem.severity)) + ": ";
    if (!problem.pointer.empty()) text += shortPointer(problem.pointer) + ": ";
    text += problem.message;
    if (!problem.remedy.empty())
        text += ". " + problem.remedy;
    return visibleText(text);
}

}  // namespace keyblock
