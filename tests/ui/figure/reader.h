// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Independent readers of the figures, if they are installed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace keyblock::test {

/// Output of `program` for a file of these bytes; none if it is not installed or fails. A `%` in the arguments is
/// replaced by the file.
std::optional<std::string> readBy(const std::string& program, const std::string& arguments, const std::string& bytes,
                                  const std::string& ending);

}  // namespace keyblock::test
