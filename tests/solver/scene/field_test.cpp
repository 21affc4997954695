// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the field table says for people: labels, units and names, complete and
// without contradictions, since forms show them as they are.
#include "solver/scene/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <stdexcept>

namespace keyblock {
namespace {

void forEachField(const std::function<void(const Structure&, const Field&)>& visit) {
    for (const Structure* structure : allStructures())
        for (const Field& field : structure->fields) visit(*structure, field);
}

std::string titleOf(const Structure& structure, const Field& field) {
    return std::string(structure.name) + '/' + std::string(field.key);
}

const Field& fieldOf(std::string_view structure, std::string_view key) {
    for (const Structure* one : allStructures())
        if (one->name == structure) return *findField(*one, key);
    throw std::invalid_argument(std::string(structure));
}

TEST(Fields, EveryFieldHasALabel) {
    forEachField([](const Structure& structure, const Field& field) {
        const std::string label = labelText(field);
        EXPECT_FALSE(label.empty()) << titleOf(structure, field);
        EXPECT_FALSE(std::islower(static_cast<unsigned char>(label.front()))) << titleOf(structure, field);
        EXPECT_EQ(label.find('_'), std::string::npos) << titleOf(structure, field);
    });
}

TEST(Fields, LabelsOfAStructureDifferUnderEachHeading) {
    for (const Structure* structure : allStructures()) {
        std::set<std::pair<std::string_view, std::string>> seen;
        for (const Field& field : structure->fields)
            EXPECT_TRUE(seen.insert({field.heading, labelText(field)}).second) << titleOf(*structure, field);
    }
}

TEST(Fields, EveryChoiceHasAWord) {
    forEachField([](const Structure& structure, const Field& field) {
        EXPECT_EQ(field.kind == FieldKind::Word, !field.words.empty() && field.kind != FieldKind::TextList)
            << titleOf(structure, field);
        EXPECT_TRUE(field.wordLabels.empty() || field.wordLabels.size() == field.words.size())
            << titleOf(structure, field);
        for (const std::string_view word : field.words)
            EXPECT_FALSE(wordLabel(field, word).empty()) << titleOf(structure, field) << ' ' << word;
    });
    EXPECT_EQ(wordLabel(fieldOf("bolt pattern", "way"), "cw"), "clockwise");
    EXPECT_EQ(wordLabel(fieldOf("bolt", "plate"), "spring"), "spring");
}

TEST(Fields, NamedListsHaveEntriesWithNames) {
    forEachField([](const Structure& structure, const Field& field) {
        const bool isText = field.kind == FieldKind::Text || field.kind == FieldKind::TextList;
        EXPECT_TRUE(field.names.empty() || isText) << titleOf(structure, field);
        for (const std::string_view key : field.names) {
            const Field* list = findField(sceneStructure(), key);
            ASSERT_TRUE(list && hasChildren(*list)) << titleOf(structure, field) << ' ' << key;
            EXPECT_TRUE(hasNames(*list)) << key;
        }
    });
}

TEST(Fields, TablesOfPairsHaveTwoColumns) {
    forEachField([](const Structure& structure, const Field& field) {
        EXPECT_EQ(field.columns.size(), field.kind == FieldKind::Pairs ? 2u : 0u) << titleOf(structure, field);
        for (const PairColumn& column : field.columns) EXPECT_FALSE(column.title.empty()) << titleOf(structure, field);
    });
}

TEST(Fields, ModuliAreStresses) {
    forEachField([](const Structure& structure, const Field& field) {
        EXPECT_TRUE(!field.isModulus || field.unit == "Pa") << titleOf(structure, field);
    });
}

TEST(Fields, UnitsOfAnAnchorFollowWhatItsValuesApplyTo) {
    Anchor anchor;
    const Field& strength = fieldOf("anchor", "strength");
    const Field& stiffness = fieldOf("anchor", "stiffness");
    const Field& curve = fieldOf("anchor", "points");
    anchor.per = Per::Length;
    EXPECT_EQ(unitIn(strength, &anchor, nullptr), "N/m");
    EXPECT_EQ(unitIn(stiffness, &anchor, nullptr), "N/m per m");
    EXPECT_EQ(unitIn(curve, curve.columns[1], &anchor, nullptr), "N/m");
    anchor.per = Per::Node;
    EXPECT_EQ(unitIn(strength, &anchor, nullptr), "N");
    EXPECT_EQ(unitIn(stiffness, &anchor, nullptr), "N/m");
    EXPECT_EQ(unitIn(curve, curve.columns[0], &anchor, nullptr), "m");
    EXPECT_EQ(unitIn(curve, curve.columns[1], &anchor, nullptr), "N");
    anchor.per = Per::Length;
    anchor.at = BoltPlace{};  // values of an entry with a position apply to its node
    EXPECT_EQ(unitIn(strength, &anchor, nullptr), "N");
}

TEST(Fields, PseudoTimeHasNoUnit) {
    Stage stage;
    stage.kind = StageKind::Static;
    const Motion motion;
    const Dilation dilation;
    const Field& table = fieldOf("motion", "table");
    EXPECT_EQ(unitIn(table, table.columns[0], &motion, &stage), "");
    EXPECT_EQ(unitIn(table, table.columns[1], &motion, &stage), "m");
    EXPECT_EQ(unitIn(fieldOf("dilation", "rate"), &dilation, &stage), "m");
    stage.kind = StageKind::Dynamic;
    EXPECT_EQ(unitIn(table, table.columns[0], &motion, &stage), "s");
    EXPECT_EQ(unitIn(fieldOf("dilation", "rate"), &dilation, &stage), "m/s");
}

}  // namespace
}  // namespace keyblock
