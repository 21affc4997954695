// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The schema and the reference page in resources/ say what the field table says.
// After a change of the table, `KEYBLOCK_REWRITE=1 ctest -R SceneReference`
// writes them anew; the change is then seen in the files' history.
#include "solver/files/json/json_tree.h"
#include "solver/files/scene/scene_reference.h"
#include "solver/scene/field.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

namespace keyblock {
namespace {

const std::filesystem::path resources = std::filesystem::path(KEYBLOCK_SOURCE_DIR) / "resources";

void expectKept(const std::filesystem::path& file, const std::string& text) {
    if (std::getenv("KEYBLOCK_REWRITE"))
        test::putContent(file, text);
    EXPECT_EQ(test::contentOf(file), text) << "write it anew: KEYBLOCK_REWRITE=1 ctest -R SceneReference";
}

TEST(SceneReference, SchemaIsThatOfTheTable) {
    expectKept(resources / "schema/keyblock-scene.schema.json", sceneSchema());
}

TEST(SceneReference, PageIsThatOfTheTable) { expectKept(resources / "help/scene.md", sceneReferencePage()); }

TEST(SceneReference, SchemaDefinesEveryStructure) {
    const JsonReading schema = readJson(sceneSchema());
    ASSERT_TRUE(schema.root && schema.problems.empty());
    const JsonNode* definitions = findMember(*schema.root, "$defs");
    ASSERT_NE(definitions, nullptr);
    EXPECT_EQ(std::get<JsonObject>(definitions->value).size() + 1, allStructures().size());
    const JsonNode* plate = findMember(*definitions, "plate");
    ASSERT_NE(plate, nullptr);
    EXPECT_NE(findMember(*findMember(*plate, "properties"), "normal_stiffness"), nullptr);
}

TEST(SceneReference, EveryRowHasHelpAndEveryStructureItsKeysOnce) {
    for (const Structure* structure : allStructures()) {
        std::set<std::string_view> keys;
        for (const Field& field : structure->fields) {
            EXPECT_FALSE(field.help.empty()) << structure->name << "." << field.key;
            EXPECT_TRUE(keys.insert(field.key).second) << structure->name << "." << field.key;
            const bool isKnown = field.only.key.empty() || findField(*structure, field.only.key);
            EXPECT_TRUE(isKnown) << structure->name << "." << field.key;
        }
    }
}

}  // namespace
}  // namespace keyblock
