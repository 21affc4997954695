// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured and published curves from CSV. The header says what each column is and
// in which unit; nothing is guessed from the numbers.
#pragma once

#include "solver/results/reference_table.h"
#include "solver/scene/problem.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace keyblock {

struct ReferenceReading {
    ReferenceTable table;
    std::vector<Problem> problems;  // with an error, the table is not to be used
};

/// Reads a header and rows; `file` is used in messages. Empty cells and `nan` are values that are not there; a column
/// of words is left out, with a warning, but for one called `stage`.
ReferenceReading readReferenceTable(std::string_view text, const std::filesystem::path& file);

/// The same from a file.
/// \throws CannotRead
ReferenceReading readReferenceFile(const std::filesystem::path& path);

}  // namespace keyblock
