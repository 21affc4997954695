// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every value of every sample can be read and written by its pointer; values that
// are invalid in a file are refused.
#include "sample_scenes.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "ui/edit/edits.h"
#include "ui/edit/locate.h"

namespace {

using namespace keyblock;

/// Pointers of all fields below an object that have a value of their own.
void collectPointers(const Structure& structure, const void* object, const std::string& pointer, std::vector<std::string>& out) {
    for (const Field& field : structure.fields) {
        const std::string place = under(pointer, field.key);
        if (field.get) out.push_back(place);
        if (!hasChildren(field)) continue;
        const Children& children = field.children;
        for (std::size_t i = 0; i < children.count(object); ++i)
            collectPointers(children.structure(), children.item(object, i),
                    field.kind == FieldKind::Object ? place
                    : field.kind == FieldKind::List ? under(place, i)
                                                    : under(place, children.name(object, i)),
                    out);
    }
}

std::vector<std::string> pointersOf(const Scene& scene) {
    std::vector<std::string> pointers;
    collectPointers(sceneStructure(), &scene, "", pointers);
    return pointers;
}

bool isOfBuiltIn(const Scene& scene, const std::string& pointer) {
    const std::vector<std::string> parts = partsOf(pointer);
    if (parts[0] != "bolt_types") return false;
    const BoltType* type = findBoltType(scene, parts[1]);
    return type && type->builtIn;
}

TEST(Values, EverySampleReadsAndWritesEveryValue) {
    for (const std::string& name : sampleNames()) {
        const Scene scene = sampleScene(name);
        for (const std::string& pointer : pointersOf(scene)) {
            const auto value = valueAt(scene, pointer);
            ASSERT_TRUE(value) << name << pointer;
            if (isOfBuiltIn(scene, pointer)) {
                EXPECT_FALSE(setValueAt(scene, pointer, *value).done()) << name << pointer;
                continue;
            }
            const Edit same = setValueAt(scene, pointer, *value);
            ASSERT_TRUE(same.done()) << name << pointer << ": " << same.refusal;
            ASSERT_EQ(same.scene, scene) << name << pointer;
        }
    }
}

TEST(Values, SettingANumberChangesNothingElse) {
    const Scene scene = sampleScene("drift-bolted");
    for (const std::string& pointer : pointersOf(scene)) {
        const auto value = valueAt(scene, pointer);
        const auto* number = std::get_if<double>(&*value);
        if (!number || isOfBuiltIn(scene, pointer)) continue;
        const ScenePlace place = *locate(scene, pointer);
        const double changed = place.field->kind == FieldKind::Integer ? *number + 1.0 : *number * 0.5 + 0.001;
        if (!contains(place.field->range, changed)) continue;
        const Edit edit = setValueAt(scene, pointer, changed);
        if (place.misplaced) {
            EXPECT_NE(edit.refusal.find("is allowed only where"), std::string::npos) << pointer;
            continue;
        }
        ASSERT_TRUE(edit.done()) << pointer << edit.refusal;
        EXPECT_EQ(valueAt(edit.scene, pointer), FieldValue(changed)) << pointer;
        EXPECT_EQ(setValueAt(edit.scene, pointer, *value).scene, scene) << pointer;
    }
}

TEST(Values, PointOfALineIsSetAndRemoved) {
    const Scene scene = sampleScene("drift-bolted");
    EXPECT_EQ(valueAt(scene, "/domain/boundary/2"), FieldValue(Point(14, 14)));
    const Edit edit = setValueAt(scene, "/domain/boundary/2", Point(13, 12));
    ASSERT_TRUE(edit.done());
    EXPECT_EQ(edit.scene.domain->boundary[2], Point(13, 12));
    EXPECT_EQ(edit.scene.domain->boundary[1], scene.domain->boundary[1]);
    EXPECT_FALSE(valueAt(scene, "/domain/boundary/4"));
    const Edit less = removeAt(scene, "/domain/boundary/1");
    ASSERT_TRUE(less.done());
    EXPECT_EQ(less.scene.domain->boundary.size(), 3u);
    EXPECT_EQ(less.pointers.now("/domain/boundary/3"), "/domain/boundary/2");
    EXPECT_FALSE(removeAt(less.scene, "/domain/boundary/0").done()) << "three corners are left";
}

TEST(Values, ValuesInvalidInAFileAreRefused) {
    const Scene scene = sampleScene("drift-bolted");
    const auto refusal = [&](const std::string& pointer, const FieldValue& value) {
        const Edit edit = setValueAt(scene, pointer, value);
        EXPECT_EQ(edit.scene, scene);
        return edit.refusal;
    };
    EXPECT_NE(refusal("/joint_materials/joint/friction_angle", 95.0).find("≥ 0"), std::string::npos);
    EXPECT_NE(refusal("/tunnels/0/profile", std::string("square")).find("not one of"), std::string::npos);
    EXPECT_NE(refusal("/tunnels/0/width", std::string("wide")).find("wrong type"), std::string::npos);
    EXPECT_NE(refusal("/joint_sets/0/seed", 1.5).find("whole"), std::string::npos);
    EXPECT_NE(refusal("/joint_sets/0/dip", FieldValue{}).find("Enter a value"), std::string::npos);
    EXPECT_NE(refusal("/joint_sets/0/spacing", std::nan("")).find("finite"), std::string::npos);
    EXPECT_NE(refusal("/joint_sets/7/spacing", 1.0).find("nothing at"), std::string::npos);
    EXPECT_NE(refusal("/nonsense", 1.0).find("nothing at"), std::string::npos);
    EXPECT_NE(refusal("", 1.0).find("nothing at"), std::string::npos);
    EXPECT_NE(refusal("/bolt_types/d-bolt-20/diameter", 0.03).find("Copy"), std::string::npos);
    EXPECT_NE(refusal("/bolt_patterns/0/type", std::string()).find("Enter a text"), std::string::npos);
    EXPECT_FALSE(refusal("/tunnels/0/center", Point(2e9, 0)).empty());
}

TEST(Values, NullAndDefaultsAreRestored) {
    const Scene scene = sampleScene("drift-bolted");
    const Edit null = setNullAt(scene, "/stages/1/relaxation");
    ASSERT_TRUE(null.done());
    EXPECT_FALSE(null.scene.stages[1].relaxation);
    const Edit reset = resetAt(scene, "/output/frames");
    EXPECT_FALSE(reset.scene.output.frames);
    EXPECT_FALSE(resetAt(scene, "/joint_sets/0/dip").done());
    const Edit gone = setNullAt(scene, "/in_situ_stress");
    ASSERT_TRUE(gone.done());
    EXPECT_FALSE(gone.scene.inSituStress);
    EXPECT_FALSE(gone.pointers.now("/in_situ_stress/sxx"));
    const Edit back = appendAt(gone.scene, "/in_situ_stress");
    EXPECT_TRUE(back.scene.inSituStress);
    EXPECT_EQ(back.made, "/in_situ_stress");
}

TEST(Values, EntryIsAddedToAndRemovedFromEveryList) {
    const Scene scene = sampleScene("drift-bolted");
    for (const Field& field : sceneStructure().fields) {
        if (field.kind != FieldKind::List && field.kind != FieldKind::Map) continue;
        const std::string list = under("", field.key);
        const Edit added = appendAt(scene, list);
        ASSERT_TRUE(added.done()) << list << added.refusal;
        ASSERT_FALSE(added.made.empty());
        EXPECT_TRUE(locate(added.scene, added.made)->isObject()) << added.made;
        const Edit removed = removeAt(added.scene, added.made);
        ASSERT_TRUE(removed.done()) << added.made << removed.refusal;
        EXPECT_EQ(removed.scene, scene) << list;
    }
}

TEST(Values, BuiltInTypeIsInTheSceneWhileItIsUsed) {
    const Scene scene = sampleScene("drift-bolted");
    const Edit other = setValueAt(scene, "/bolt_patterns/0/type", std::string("rebar-20"));
    ASSERT_TRUE(other.done());
    EXPECT_TRUE(findBoltType(other.scene, "rebar-20"));
    EXPECT_FALSE(findBoltType(other.scene, "d-bolt-20"));
    EXPECT_EQ(setValueAt(other.scene, "/bolt_patterns/0/type", std::string("d-bolt-20")).scene, scene);
}

TEST(Values, EntryMovesInItsList) {
    const Scene scene = sampleScene("drift-bolted");
    const Edit edit = moveAt(scene, "/stages/0", 2);
    ASSERT_TRUE(edit.done());
    EXPECT_EQ(edit.scene.stages[2].name, "settle");
    EXPECT_EQ(edit.scene.stages[0].name, "excavate");
    EXPECT_EQ(edit.pointers.now("/stages/0/kind"), "/stages/2/kind");
    EXPECT_EQ(edit.pointers.now("/stages/2"), "/stages/1");
    EXPECT_EQ(edit.pointers.now("/stages/3"), "/stages/3");
    EXPECT_EQ(moveAt(edit.scene, "/stages/2", 0).scene, scene);
    EXPECT_EQ(moveAt(scene, "/stages/0", 99).scene.stages.back().name, "settle");
    EXPECT_FALSE(moveAt(scene, "/domain", 1).done());
}

TEST(Pointers, InvalidPointersLeadNowhere) {
    const Scene scene = sampleScene("drift-bolted");
    for (const char* pointer : {"/", "//", "domain", "/domain/", "/joints/-1", "/joint_sets/00x", "/joint_sets/1e3",
                                "/materials/", "/materials/~2", "/stages/0/until/x", "/domain/boundary/0/0",
                                "/joint_sets/99999999999999999999"})
        EXPECT_FALSE(valueAt(scene, pointer)) << pointer;
    EXPECT_EQ(objectPointer(scene, "/joint_sets/1/dip"), "/joint_sets/1");
    EXPECT_EQ(objectPointer(scene, "/domain/boundary/2"), "/domain");
    EXPECT_EQ(objectPointer(scene, "/joint_sets/9/dip"), "");
    EXPECT_EQ(objectPointer(scene, "/stages/4/loads/0/pressure"), "/stages/4/loads/0");
}

}  // namespace
