// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output_files.h"

#include "app/cli/output.h"

#include <system_error>

namespace keyblock::cli {

namespace {

std::string problemOf(const OutputFile& file, std::span<const std::filesystem::path> sources) {
    if (const std::string why = whyKept(file.path, sources, file.scenes); !why.empty())
        return why + " and is not replaced; choose another name";
    std::error_code error;
    if (!file.replaces && std::filesystem::is_regular_file(file.path, error))
        return file.path.string() + " exists; add --overwrite to replace it, or choose another --out";
    return {};
}

}  // namespace

bool mayBeWritten(std::span<const OutputFile> files, std::span<const std::filesystem::path> sources) {
    bool may = true;
    for (const OutputFile& file : files)
        if (const std::string problem = problemOf(file, sources); !problem.empty()) {
            printErrorLine(problem);
            may = false;
        }
    return may;
}

}  // namespace keyblock::cli
