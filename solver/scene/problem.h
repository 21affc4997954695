// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with a scene, for the user: where it is, what it is and what
// to do about it. A bad scene is not an exception but a list of these, all at once.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// An error keeps a scene from running; a warning is likely a mistake; a note reports what has no effect.
enum class Severity { Error, Warning, Note };

/// An edit that removes a problem and needs no decision of the user.
enum class RepairKind {
    None,  // the user has to decide
    Rename,  // the object at the pointer gets a free name
    Omit,  // the field at the pointer gets its default; an element of a list is removed
    SetAutomatic,  // the field at the pointer becomes null
    RemovePlate,  // the plate at the pointer becomes `none`
    AddNamed,  // an entry `name` is added to the map at the pointer
    AddStage  // to the end of the list at the pointer
};

struct Repair {
    RepairKind kind = RepairKind::None;
    std::string pointer{};  // JSON pointer into the scene
    std::string name{};  // of the entry that is added

    bool operator==(const Repair&) const = default;
};

struct Problem {
    Severity severity = Severity::Error;
    std::string file;  // as given by the caller, or the option that set the value; empty for scenes built in code
    int line = 0;  // from 1; 0: not known, or not from a file
    std::string pointer;  // JSON pointer (RFC 6901) into the scene; empty: the whole scene
    std::string message;  // what is wrong
    std::string remedy;  // what to do
    Repair repair{};  // the same as an edit, where the program can make it

    bool operator==(const Problem&) const = default;
};

/// No list holds more: with a thousand problems the user corrects some and checks again.
inline constexpr std::size_t mostProblems = 1000;

/// Appends to a list that is not full. Half of it is kept for errors; the last entry says that more follow.
void addProblem(std::vector<Problem>& problems, Problem problem);

/// True when nothing more can be appended, so that looking further is of no use.
bool isFull(std::span<const Problem> problems);

/// True when one of them is an error.
bool hasErrors(std::span<const Problem> problems);

/// `error`, `warning` or `note`.
std::string_view wordOf(Severity severity);

/// The problem on one line: file, line, severity, pointer, message, remedy.
std::string oneLine(const Problem& problem);

}  // namespace keyblock
