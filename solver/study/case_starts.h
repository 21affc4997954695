// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Starts of a case that never ended. A case that ends its process each time, for example
// because the system has no memory for it, becomes a row with this reason and does not
// keep a task from its other cases forever.
#pragma once

#include <filesystem>

namespace keyblock {

/// Starts from the same point without an end after which a case is given up.
inline constexpr int mostStarts = 5;

class CaseStarts {
public:
    /// Notes a start. \param progress a number that grows with the point from which the case starts.
    /// \throws CannotWrite
    CaseStarts(const std::filesystem::path& folder, long progress);

    /// Whether the case ended without a result `mostStarts` times at this point.
    bool isHopeless() const { return before_ >= mostStarts; }

    /// Forgets all starts: the case ended, or was interrupted properly.
    void forget() const;

private:
    std::filesystem::path file_;
    int before_ = 0;  // earlier starts from the same point
};

}  // namespace keyblock
