// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_template.h"

#include <algorithm>
#include <sstream>

namespace keyblock {

namespace {

constexpr const char* spaces = " \t\r";

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(spaces) - first + 1));
}

std::string contentWords() {
    std::string words;
    for (const ReportContentRow& row : reportContents) words += (words.empty() ? "" : ", ") + std::string(row.word);
    return words;
}

class TemplateReader {
public:
    TemplateReading read(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
        std::istringstream lines{std::string(text)};
        for (std::string line; problem_.empty() && std::getline(lines, line);) {
            ++number_;
            take(trimmed(line));
        }
        if (problem_.empty() && layout_.sections.empty()) fail("there is no section; write one as [summary]");
        if (!problem_.empty()) return {std::nullopt, problem_};
        return {layout_, ""};
    }

private:
    void fail(const std::string& what) {
        if (problem_.empty()) problem_ = "line " + std::to_string(std::max(1, number_)) + ": " + what;
    }

    void take(const std::string& line) {
        if (line.starts_with("#")) return;
        if (line.empty()) {
            newParagraph_ = true;
        } else if (line.starts_with("[")) {
            beginSection(line);
        } else if (layout_.sections.empty()) {
            readSetting(line);
        } else {
            std::vector<std::string>& paragraphs = layout_.sections.back().paragraphs;
            if (newParagraph_ || paragraphs.empty()) paragraphs.push_back(line);
            else paragraphs.back() += " " + line;
            newParagraph_ = false;
        }
    }

    void beginSection(const std::string& line) {
        if (!line.ends_with("]")) return fail("'" + line + "' has no ']' at its end");
        const std::string inner = line.substr(1, line.size() - 2);
        const std::size_t colon = inner.find(':');
        const std::string word = trimmed(inner.substr(0, colon));
        const auto row = std::ranges::find(reportContents, word, &ReportContentRow::word);
        if (row == reportContents.end()) return fail("there is no section '" + word + "'; there are " + contentWords());
        layout_.sections.push_back({row->content, colon == std::string::npos ? "" : trimmed(inner.substr(colon + 1))});
        if (row->content == ReportContent::Text && layout_.sections.back().heading.empty())
            fail("a text needs a heading; write [text: HEADING]");
        newParagraph_ = true;
    }

    void readSetting(const std::string& line) {
        const std::size_t space = line.find_first_of(spaces);
        const std::string key = line.substr(0, space);
        const std::string value = space == std::string::npos ? "" : trimmed(line.substr(space));
        if (key != "title" && key != "logo")
            return fail("'" + key + "' is neither title nor logo; texts follow a section such as [text: HEADING]");
        if (value.empty()) return fail("'" + key + "' has no value; write it after the word, or remove the line");
        (key == "title" ? layout_.title : layout_.logo) = value;
    }

    ReportTemplate layout_;
    std::string problem_;
    int number_ = 0;
    bool newParagraph_ = true;
};

}  // namespace

ReportTemplate defaultTemplate(ReportKind kind) {
    ReportTemplate layout;
    for (const ReportContentRow& row : reportContents)
        if (row.content != ReportContent::Text && appliesTo(row, kind)) layout.sections.push_back({row.content, ""});
    return layout;
}

TemplateReading readTemplate(std::string_view text) { return TemplateReader().read(text); }

std::string templateText(const ReportTemplate& layout) {
    std::string text;
    if (!layout.title.empty()) text += "title " + layout.title + "\n";
    if (!layout.logo.empty()) text += "logo " + layout.logo + "\n";
    for (const TemplateSection& section : layout.sections) {
        text += (text.empty() ? "[" : "\n[") + std::string(rowOf(section.content).word);
        if (!section.heading.empty()) text += ": " + section.heading;
        text += "]\n";
        for (const std::string& paragraph : section.paragraphs)
            text += (&paragraph == section.paragraphs.data() ? "" : "\n") + paragraph + "\n";
    }
    return text;
}

std::string mediaTypeOf(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1A\n")) return "image/png";
    if (bytes.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
    const std::string_view begin = bytes.substr(0, 1000);
    if (begin.find("<svg") != std::string_view::npos && begin.find_first_not_of(" \t\r\n") != std::string_view::npos &&
        begin[begin.find_first_not_of(" \t\r\n")] == '<')
        return "image/svg+xml";
    return {};
}

}  // namespace keyblock
