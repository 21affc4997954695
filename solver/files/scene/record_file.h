// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records of acceleration from CSV files. Spreadsheets write decimal commas,
// semicolons, tabs and quotes as it suits the country they run in; every such
// file is refused in words, with row and column, and never half understood.
#pragma once

#include "solver/scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct RecordReading {
    struct Fault {
        std::string message;  // with row and column, from 1, the header being row 1
        std::string remedy;
    };
    Table record;  // (time [s], value); empty where there are faults
    std::vector<Fault> faults;  // a mistake of the whole file only, else the first ten of single cells
};

/// Reads `time_s,a` and rows of two numbers: decimal points, rising times from 0 on, spaces around a number, either
/// end of line, a byte order mark and empty rows at the end allowed.
RecordReading readRecordText(std::string_view text);

/// The same from a file; one that cannot be opened is a fault.
RecordReading readRecordFile(const std::filesystem::path& path);

}  // namespace keyblock
