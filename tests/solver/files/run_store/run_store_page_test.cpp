// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help page on the run store names tables, columns and values that exist, and
// none of the schema is left out.
#include "solver/files/run_store/frame_payload.h"
#include "solver/files/run_store/run_schema.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace keyblock {
namespace {

const std::string& page() {
    static const std::string text = test::contentOf(KEYBLOCK_SOURCE_DIR "/resources/help/run-store.md");
    return text;
}

std::string example() {
    const auto begin = page().find("```python\n") + 10;
    return page().substr(begin, page().find("```", begin) - begin);
}

/// Everything between `quote` and `quote` in a text.
std::vector<std::string> quoted(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i) found.push_back((*i)[1]);
    return found;
}

class RunStorePage : public ::testing::Test {
protected:
    RunStorePage() {
        sqlite3_open(":memory:", &database_);
        EXPECT_EQ(sqlite3_exec(database_, run_schema::tables, nullptr, nullptr, nullptr), SQLITE_OK);
    }
    ~RunStorePage() override { sqlite3_close(database_); }

    /// What SQLite says against a statement; empty where it takes it.
    std::string fault(const std::string& statement) const {
        sqlite3_stmt* prepared = nullptr;
        const int answer = sqlite3_prepare_v2(database_, statement.c_str(), -1, &prepared, nullptr);
        sqlite3_finalize(prepared);
        return answer == SQLITE_OK ? "" : sqlite3_errmsg(database_);
    }

    std::map<std::string, std::set<std::string>> columns() const {
        std::map<std::string, std::set<std::string>> all;
        const auto add = [](void* target, int, char** values, char**) {
            (*static_cast<std::map<std::string, std::set<std::string>>*>(target))[values[0]].insert(values[1]);
            return 0;
        };
        sqlite3_exec(database_,
                     "SELECT m.name, c.name FROM sqlite_master m, pragma_table_info(m.name) c WHERE m.type = 'table'", add,
                     &all, nullptr);
        return all;
    }

private:
    sqlite3* database_ = nullptr;
};

TEST_F(RunStorePage, ListsEveryTableAndColumn) {
    std::map<std::string, std::set<std::string>> listed;
    for (const std::string& line : quoted(page(), "\n(\\| `[^\n]*)")) {
        const std::vector<std::string> names = quoted(line.substr(0, line.find(':')), "`([a-z_]+)`");
        listed[names[0]].insert(names.begin() + 1, names.end());
    }
    auto schema = columns();
    schema["checkpoint"].clear();
    listed["columns"].insert({"payload", "position", "name", "unit", "meaning"});
    EXPECT_EQ(listed, schema);
}

TEST_F(RunStorePage, TheExampleAsksForWhatThereIs) {
    const std::string code = std::regex_replace(example(), std::regex("\"\\s*\n\\s*\""), "");
    std::vector<std::string> statements = quoted(code, "\"(SELECT [^\"]*)\"");
    for (const std::string& more : quoted(code, "'(SELECT [^']*)'")) statements.push_back(more);
    EXPECT_GE(statements.size(), 5U);
    for (const std::string& statement : statements) EXPECT_EQ(fault(statement), "") << statement;
    EXPECT_NE(fault("SELECT velocity FROM frames"), "");
}

TEST_F(RunStorePage, TheExampleUsesValuesThatRowsHave) {
    std::set<std::string> known;
    for (const Payload payload : {Payload::Blocks, Payload::Nodes})
        for (const PayloadColumn& column : payloadColumns(payload)) known.insert(std::string(column.name));
    std::vector<std::string> used = quoted(example(), "(?:block|node|lowest|most)\\[[\"']([a-z_]+)[\"']\\]");
    EXPECT_GE(used.size(), 4U);
    for (const std::string& name : used) EXPECT_TRUE(known.contains(name)) << name;
}

/// `name` in a text about the rows of a frame.
TEST_F(RunStorePage, TellsOfContactsAndBondsWhatRowsHave) {
    const std::pair<Payload, const char*> parts[]{{Payload::Contacts, "**Contacts.**"}, {Payload::Nodes, "**Bonds.**"}};
    for (const auto& [payload, heading] : parts) {
        const std::size_t begin = page().find(heading);
        ASSERT_NE(begin, std::string::npos) << heading;
        const std::string text = page().substr(begin, page().find("\n**", begin) - begin);
        std::set<std::string> known;
        for (const PayloadColumn& column : payloadColumns(payload)) known.insert(std::string(column.name));
        const std::vector<std::string> names = quoted(text, "`([a-z_]+)`");
        EXPECT_GE(names.size(), 2U);
        for (const std::string& name : names) EXPECT_TRUE(known.contains(name)) << name;
    }
}

}  // namespace
}  // namespace keyblock
