// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/csv/number_text_reader.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace keyblock {

bool readReal(std::string_view text, double& number) {
    constexpr double largest = 1e15;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    return !text.empty() && failure == std::errc() && end == text.data() + text.size() && std::abs(number) < largest;
}

bool readInteger(std::string_view text, int& number) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    return !text.empty() && failure == std::errc() && end == text.data() + text.size();
}

}  // namespace keyblock
