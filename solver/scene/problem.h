// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Problems of a scene, for the user: the location, what is wrong and how to fix it.
// An invalid scene does not throw; all its problems are returned in one list.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// An error prevents a run, a warning reports a likely mistake, and a note reports input that has no effect.
enum class Severity { Error, Warning, Note };

/// Kind of edit that fixes a problem automatically.
enum class RepairKind {
    None,  // the user has to decide
    Rename,  // gives the object at the pointer an unused name
    Omit,  // resets the field at the pointer to its default, or removes the list element
    SetAutomatic,  // sets the field at the pointer to null
    RemovePlate,  // sets the plate at the pointer to `none`
    AddNamed,  // adds an entry `name` to the map at the pointer
    AddStage  // adds a stage at the end of the list at the pointer
};

struct Repair {
    RepairKind kind = RepairKind::None;
    std::string pointer{};  // JSON pointer into the scene
    std::string name{};  // name of the entry to add

    bool operator==(const Repair&) const = default;
};

struct Problem {
    Severity severity = Severity::Error;
    std::string file;  // file name as given, or the option that set the value; empty for scenes built in code
    int line = 0;  // starting at 1; 0: unknown, or not from a file
    std::string pointer;  // JSON pointer (RFC 6901) into the scene; empty: the whole scene
    std::string message;  // what is wrong
    std::string remedy;  // what to do
    Repair repair{};  // the remedy as an automatic edit, if there is one

    bool operator==(const Problem&) const = default;
};

/// Maximum number of problems in a list. If there are more, the user can fix some of them and check again.
inline constexpr std::size_t mostProblems = 1000;

/// Appends a problem unless the list is full. Warnings and notes are appended only while the list is less than half
/// full. The message of the entry that fills the list is replaced by one saying that there are more problems.
void addProblem(std::vector<Problem>& problems, Problem problem);

/// True if no more problems can be appended, so that further checks are pointless.
bool isFull(std::span<const Problem> problems);

/// True if at least one of the problems is an error.
bool hasErrors(std::span<const Problem> problems);

/// `error`, `warning` or `note`.
std::string_view wordOf(Severity severity);

/// The problem as one line of text: file, line, severity, pointer, message and remedy, with control characters escaped.
std::string oneLine(const Problem& problem);

}  // namespace keyblock
