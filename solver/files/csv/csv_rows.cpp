// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/csv/csv_rows.h"

#include "solver/files/text_encoding.h"
#include "solver/scene/formula_text.h"

#include <algorithm>

namespace keyblock {

namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

class Splitter {
public:
    explicit Splitter(std::string_view text)
        : text_(text), lineEnd_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {}

    CsvRows split() {
        while (at_ < text_.size() && cells_ <= mostCsvCells) readLine();
        if (cells_ > mostCsvCells)
            read_.problems.push_back({Severity::Error, "", line_, "",
                                      "the file has more than " + std::to_string(mostCsvCells) + " cells",
                                      "Give fewer rows or columns"});
        return std::move(read_);
    }

private:
    void readLine() {
        const int first = line_;
        const auto stop = std::min(text_.find(lineEnd_, at_), text_.size());
        const std::string plain = trimmed(std::string(text_.substr(at_, stop - at_)));
        const std::string blank = std::string(" \t\r") + separatorOf(plain);
        if (plain.starts_with('#') || plain.find_first_not_of(blank) == std::string::npos) {
            at_ = stop + 1;
            ++line_;
            return;
        }
        if (read_.rows.empty()) read_.separator = separatorOf(plain);
        CsvRow row;
        while (cells_ <= mostCsvCells && readCell(row)) {
        }
        if (row.empty()) row.push_back({"", first, false});
        read_.rows.push_back(std::move(row));
    }

    char separatorOf(const std::string& line) const {
        if (!read_.rows.empty()) return read_.separator;
        std::string outside;
        bool quoted = false;
        for (const char c : line) {
            quoted = quoted != (c == '"');
            if (!quoted) outside += c;
        }
        for (const char c : {'\t', ';'})
            if (outside.find(c) != std::string::npos) return c;
        return ',';
    }

    /// \return false at the end of the row.
    bool readCell(CsvRow& row) {
        CsvCell cell;
        ++cells_;
        cell.line = line_;
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        if (at_ < text_.size() && text_[at_] == '"') readQuoted(cell);
        while (at_ < text_.size() && text_[at_] != read_.separator && text_[at_] != lineEnd_) cell.text += text_[at_++];
        const bool more = at_ < text_.size() && text_[at_] == read_.separator;
        if (!more && cell.text.ends_with('\r')) cell.text.pop_back();
        if (!more) ++line_;
        ++at_;
        const std::string text = cell.quoted ? cell.text : trimmed(cell.text);
        cell.text = trimmed(asUtf8(asBeforeMarking(text), ""));
        row.push_back(std::move(cell));
        return more;
    }

    void readQuoted(CsvCell& cell) {
        cell.quoted = true;
        ++at_;
        while (at_ < text_.size()) {
            const char c = text_[at_++];
            if (c == '"' && !(at_ < text_.size() && text_[at_] == '"')) return;
            if (c == '"') ++at_;
            if (c == lineEnd_) ++line_;
            cell.text += c;
        }
        read_.problems.push_back({Severity::Error, "", cell.line, "", "a quote is opened here but never closed",
                                  "Close it, or remove it"});
    }

    std::string_view text_;
    char lineEnd_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::size_t cells_ = 0;
    CsvRows read_;
};

}  // namespace

CsvRows readCsvRows(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (text.find('\0') == std::string_view::npos) return Splitter(text).split();
    CsvRows read;
    read.problems.push_back({Severity::Error, "", 0, "", "this is not plain text (it contains zero bytes, as UTF-16 does)",
                             "Save it as CSV in UTF-8"});
    return read;
}

}  // namespace keyblock
