// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes of others may have names that control a terminal or are formulas in a
// spreadsheet.
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

namespace keyblock::test {
namespace {

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

class OddNames : public CommandLine {
protected:
    /// The scene `pull.json` in which bolt and stage have this name, in JSON.
    void putNamed(const std::string& name) const {
        putPullScene();
        std::string text = content("pull.json");
        replaceAll(text, "\"B\"", "\"" + name + "\"");
        replaceAll(text, "\"name\": \"pull\"", "\"name\": \"" + name + "\"");
        replaceAll(text, "A joint opens across a bolt", "A joint " + name);
        put("pull.json", text);
    }
    static bool controlsATerminal(const std::string& text) {
        return text.find_first_of("\x1b\x07\r\x7f") != std::string::npos || text.find("\u009b") != std::string::npos ||
               text.find("\u202e") != std::string::npos;
    }
};

TEST_F(OddNames, AreShownAsEscapesOnTheTerminal) {
    putNamed("n\\u001b[2J\\u0007\\u009b2J\\u202e\\n\\r\\u007fo");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"check", "pull.json"},
             {"check", "pull.json", "--json"},
             {"run", "pull.json", "--progress", "json"},
             {"run", "pull.json", "--progress", "bar", "--overwrite"},
             {"info", "pull.kbrun"},
             {"info", "pull.kbrun", "--json"},
             {"export", "pull.kbrun", "--table", "bolts", "--bolt", "n\x1b[2J", "--out", "t.csv"}}) {
        const Ended ended = keyblock(words);
        std::string errors = ended.err;
        if (words.back() == "--overwrite") replaceAll(errors, "\r\x1b[K", "");  // the bar replaces its own line
        EXPECT_FALSE(controlsATerminal(ended.out)) << words.front() << "\n" << ended.out;
        EXPECT_FALSE(controlsATerminal(errors)) << words.front() << "\n" << errors;
    }
    EXPECT_NE(keyblock({"info", "pull.kbrun"}).out.find("n\\u001b[2J\\u0007\\u009b2J\\u202e\\n\\r\\u007fo"),
              std::string::npos);
    const std::string name = nlohmann::json::parse(keyblock({"info", "pull.kbrun", "--json"}).out)["stages"][0]["name"];
    EXPECT_EQ(name, "n\x1b[2J\x07\u009b2J\u202e\n\r\x7fo");  // JSON keeps the name
}

TEST_F(OddNames, ErrorsKeepOneLineEach) {
    putNamed("a\\nerror: b");
    std::string text = content("pull.json");
    replaceAll(text, "rebar-20-paper", "none\\nsuch");
    put("pull.json", text);
    const Ended ended = keyblock({"check", "pull.json"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
}

TEST_F(OddNames, FormulasAreTextInTables) {
    putNamed("=cmd|' /C calc'!A0");
    ASSERT_EQ(keyblock({"run", "pull.json", "--progress", "none"}).code, 0);
    for (const std::string name : {"events", "bolts", "blocks", "history", "energy", "contacts", "forces"}) {
        const std::string table = this->table("pull.kbrun", name);
        for (const std::string& line : lines(table)) {
            EXPECT_NE(line.front(), '=') << name << ": " << line;
            EXPECT_EQ(line.find(",="), std::string::npos) << name << ": " << line;
        }
    }
    EXPECT_NE(table("pull.kbrun", "bolts").find("'=cmd|"), std::string::npos);
}

}  // namespace
}  // namespace keyblock::test
