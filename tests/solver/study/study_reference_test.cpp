// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The schema and the reference page of studies in resources/ say what the field table
// says; KEYBLOCK_REWRITE=1 writes them again.
#include "solver/study/study_reference.h"

#include "solver/scene/structure_list.h"
#include "solver/study/study_fields.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace keyblock {
namespace {

void expectKeptText(const std::string& file, const std::string& text) {
    const std::filesystem::path path = std::filesystem::path(KEYBLOCK_SOURCE_DIR) / "resources" / file;
    if (std::getenv("KEYBLOCK_REWRITE")) test::putContent(path, text);
    EXPECT_EQ(test::contentOf(path), text) << "write it again: KEYBLOCK_REWRITE=1 ctest -R StudyReference";
}

TEST(StudyReference, SchemaIsThatOfTheTable) { expectKeptText("schema/keyblock-study.schema.json", studySchema()); }

TEST(StudyReference, PageIsThatOfTheTable) { expectKeptText("help/study.md", studyReferencePage()); }

TEST(StudyReference, EveryRowHasHelpAndEveryStructureItsKeysOnce) {
    for (const Structure* structure : structuresFrom(studyStructure())) {
        std::set<std::string_view> keys;
        for (const Field& field : structure->fields) {
            EXPECT_FALSE(field.help.empty()) << structure->name << "." << field.key;
            EXPECT_TRUE(keys.insert(field.key).second) << structure->name << "." << field.key;
            EXPECT_TRUE(field.only.key.empty() || findField(*structure, field.only.key)) << field.key;
        }
    }
}

}  // namespace
}  // namespace keyblock
