// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other people's readers of our figures, where they are installed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace keyblock::test {

/// What `program` prints for a file of these bytes; nothing when it is not installed or fails. A `%` in the arguments
/// stands for the file.
std::optional<std::string> readBy(const std::string& program, const std::string& arguments, const std::string& bytes,
                                  const std::string& ending);

}  // namespace keyblock::test
