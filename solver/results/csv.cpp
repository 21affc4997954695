// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers are formatted with std::to_chars, the only formatting that does not depend
// on the locale.
#include "solver/results/csv.h"

#include "solver/scene/formula_text.h"

#include <array>
#include <charconv>

namespace keyblock {

std::string exactText(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 17);
    return {buffer.data(), end.ptr};
}

CsvWriter& CsvWriter::text(std::string_view name) {
    const std::string value = withoutFormula(name);
    if (value.find_first_of(",\"\r\n") == std::string_view::npos) {
        cell(value);
        return *this;
    }
    std::string quoted = "\"";
    for (const char c : value)
        quoted.append(c == '"' ? 2 : 1, c);
    cell(quoted + '"');
    return *this;
}

CsvWriter& CsvWriter::number(double value) {
    cell(exactText(value));
    return *this;
}

CsvWriter& CsvWriter::integer(long value) {
    cell(std::to_string(value));
    return *this;
}

CsvWriter& CsvWriter::index(int value) {
    cell(value < 0 ? "" : std::to_string(value));
    return *this;
}

void CsvWriter::endRow() {
    out_.put('\n');
    rowBegun_ = false;
}

void CsvWriter::cell(std::string_view value) {
    if (rowBegun_)
        out_.put(',');
    out_.write(value.data(), static_cast<std::streamsize>(value.size()));
    rowBegun_ = true;
}

}  // namespace keyblock
