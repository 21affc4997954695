// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comments point to the help page by the name of a section: theory, "Blocks". A
// section that is renamed must not leave them behind.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> sectionsOf(const std::string& page) {
    std::set<std::string> sections;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("## ")) sections.insert(line.substr(3));
    return sections;
}

/// Every section that a source text names, also where a comment breaks the line within the name.
std::set<std::string> sectionsNamedIn(const std::string& source) {
    static const std::regex lineBreak("\n */+ *");
    static const std::regex reference("theory, \"([^\"]+)\"");
    std::set<std::string> named;
    if (source.find("theory,") == std::string::npos) return named;
    const std::string joined = std::regex_replace(source, lineBreak, " ");
    for (std::sregex_iterator found(joined.begin(), joined.end(), reference), end; found != end; ++found)
        named.insert((*found)[1]);
    return named;
}

TEST(Help, HoldsEverySectionThatTheSourcesName) {
    const fs::path root = KEYBLOCK_SOURCE_DIR;
    const std::set<std::string> sections = sectionsOf(textOf(root / "resources/help/theory.md"));
    std::size_t references = 0;
    for (const char* floor : {"geometry", "solver", "app", "ui", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(root / floor)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
            for (const std::string& section : sectionsNamedIn(textOf(entry.path()))) {
                EXPECT_TRUE(sections.contains(section)) << entry.path() << " names the section " << section;
                ++references;
            }
        }
    EXPECT_GT(references, 0u);
}

TEST(Help, FindsSectionsAndNames) {
    EXPECT_EQ(sectionsOf("# Theory\n## Blocks\ntext\n## The step\n"), (std::set<std::string>{"Blocks", "The step"}));
    EXPECT_EQ(sectionsNamedIn("/// (theory, \"No such section\")"), std::set<std::string>{"No such section"});
    EXPECT_EQ(sectionsNamedIn("    /// (theory, \"The\n    /// step\")"), std::set<std::string>{"The step"});
}

}  // namespace
