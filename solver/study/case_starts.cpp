// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/case_starts.h"

#include "solver/files/atomic_file.h"

#include <fstream>
#include <system_error>

namespace keyblock {

CaseStarts::CaseStarts(const std::filesystem::path& folder, long progress) : file_(folder / "starts") {
    long point = 0;
    int starts = 0;
    if (std::ifstream file(file_); file >> point >> starts && point == progress) before_ = starts;
    writeAtomically(file_, [&](std::ostream& out) { out << progress << ' ' << before_ + 1 << '\n'; });
}

void CaseStarts::forget() const {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

}  // namespace keyblock
