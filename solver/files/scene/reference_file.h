// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads measured and published curves from CSV. The header gives the name and unit of
// each column; nothing is guessed from the numbers.
#pragma once

#include "solver/results/reference_table.h"
#include "solver/scene/problem.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace keyblock {

struct ReferenceReading {
    ReferenceTable table;
    std::vector<Problem> problems;  // if any is an error, the table must not be used
};

/// Reads a table from CSV text: a header, then rows. Empty cells and `nan` are missing values. A column without numbers
/// is left out with a warning, unless it is the column `stage`.
/// \param file the file name for messages.
ReferenceReading readReferenceTable(std::string_view text, const std::filesystem::path& file);

/// Reads a table from a CSV file, like `readReferenceTable`.
/// \throws CannotRead if the file cannot be opened or is too large.
ReferenceReading readReferenceFile(const std::filesystem::path& path);

}  // namespace keyblock
