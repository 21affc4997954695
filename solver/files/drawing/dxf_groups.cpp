// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/drawing/dxf_groups.h"

#include "solver/files/csv/number_text_reader.h"
#include "solver/scene/suggest.h"

#include <charconv>
#include <cmath>

namespace keyblock {

namespace {

constexpr int commentCode = 999;
constexpr int lowestCode = -5, highestCode = 1071;

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Reads a text line by line; files from old Macs end lines with a carriage return only.
class Lines {
public:
    explicit Lines(std::string_view text)
        : text_(text), end_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {}

    bool next(std::string_view& line) {
        if (at_ >= text_.size()) return false;
        const auto stop = std::min(text_.find(end_, at_), text_.size());
        line = text_.substr(at_, stop - at_);
        at_ = stop + 1;
        ++number_;
        return true;
    }
    int number() const { return number_; }

private:
    std::string_view text_;
    char end_;
    std::size_t at_ = 0;
    int number_ = 0;
};

void error(DxfGroups& read, int line, std::string message, std::string remedy) {
    read.problems.push_back({Severity::Error, "", line, "", std::move(message), std::move(remedy)});
}

bool isDxfText(std::string_view text, DxfGroups& read) {
    const std::string remedy = "Save it as a text (ASCII) DXF";
    if (text.starts_with("AutoCAD Binary DXF"))
        error(read, 1, "this is a binary DXF", remedy);
    else if (text.starts_with("AC10"))
        error(read, 1, "this is a DWG file", remedy);
    else if (text.find('\0') != std::string_view::npos)
        error(read, 0, "this is not a text file (it contains zero bytes)", remedy);
    else if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        error(read, 0, "the file is empty", "Give a DXF file with lines in it");
    return read.problems.empty();
}

std::string textAfterEnd(Lines& lines) {
    std::string_view line;
    while (lines.next(line))
        if (!trimmed(line).empty()) return std::string(line);
    return {};
}

/// Reads pairs until the end.
/// \return false if the file ends without an end mark.
bool readPairs(Lines& lines, DxfGroups& read) {
    std::string_view codeText, value;
    while (lines.next(codeText)) {
        int code = 0;
        const bool blank = trimmed(codeText).empty();
        if (!readInteger(trimmed(codeText), code) || code < lowestCode || code > highestCode) {
            if (blank && textAfterEnd(lines).empty()) return false;
            error(read, lines.number(), "a group code is expected here, not " + inQuotes(trimmed(codeText)),
                  "The lines of a DXF come in pairs of a code and a value: correct the lines that were lost or added "
                  "before this line");
            return true;
        }
        if (!lines.next(value)) return false;
        if (code == commentCode) continue;
        const bool number = (code >= 60 && code < 100) || isRealCode(code) || code == 0 || code == 9;
        read.groups.push_back({code, number ? trimmed(value) : value.substr(0, value.find('\r')), lines.number()});
        if (code == 0 && read.groups.back().value == "EOF") return true;
    }
    return false;
}

/// True if the last section has no end mark.
bool endsAmid(const DxfGroups& read) {
    bool inside = false;
    for (const DxfGroup& group : read.groups)
        if (group.code == 0 && (group.value == "SECTION" || group.value == "ENDSEC")) inside = group.value == "SECTION";
    return inside;
}

}  // namespace

bool isRealCode(int code) {
    return (code >= 10 && code < 60) || (code >= 110 && code < 150) || (code >= 210 && code < 240) ||
           (code >= 460 && code < 470) || (code >= 1010 && code < 1060);
}

DxfGroups readDxfGroups(std::string_view text) {
    DxfGroups read;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (!isDxfText(text, read)) return read;
    Lines lines(text);
    const bool ended = readPairs(lines, read);
    if (hasErrors(read.problems)) return read;
    if (!ended && endsAmid(read))
        error(read, lines.number(), "the file ends in the middle of a section: it is incomplete",
              "Export or copy it again");
    else if (!ended)
        read.problems.push_back({Severity::Warning, "", lines.number(), "", "the file ends without EOF",
                                 "Check whether anything is missing"});
    else if (const int end = lines.number(); !textAfterEnd(lines).empty())
        read.problems.push_back({Severity::Warning, "", end + 1, "", "there are lines after EOF, which were not read",
                                 "Check whether two files were joined"});
    return read;
}

}  // namespace keyblock
