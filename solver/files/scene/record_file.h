// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads acceleration records from CSV files. Depending on the locale, spreadsheets
// write decimal commas, semicolons, tabs and quotes. Such a file is rejected with a
// message that gives row and column; it is never read in part.
#pragma once

#include "solver/scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct RecordReading {
    struct Fault {
        std::string message;  // includes row and column, counted from 1; the header is row 1
        std::string remedy;
    };
    Table record;  // (time [s], value); empty if there are faults
    std::vector<Fault> faults;  // at most about ten; reading stops at a fault that affects the whole file
};

/// Reads a record from CSV text: the header `time_s,a`, then rows of two numbers with decimal points, not commas. Times
/// must not be negative and must increase. Spaces around numbers, LF or CRLF line endings, a byte order mark and empty
/// rows at the end are allowed.
RecordReading readRecordText(std::string_view text);

/// Reads a record from a file, like `readRecordText`. If the file cannot be opened, this is reported as a fault.
RecordReading readRecordFile(const std::filesystem::path& path);

}  // namespace keyblock
