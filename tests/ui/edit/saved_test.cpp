// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// After any edits a scene can be written and read back identical to the byte.
// KEYBLOCK_EDITS sets the number of random edits of each sample (40), KEYBLOCK_SEED
// the random seed.
#include "sample_scenes.h"
#include "solver/files/scene/bolt_library.h"
#include "solver/files/scene/scene_rescue.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "ui/edit/edits.h"
#include "ui/edit/locate.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using namespace keyblock;

int numberFrom(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

struct Pointers {
    std::vector<std::string> values, objects, lists;
    std::vector<std::string> deciders;  // fields that decide which others apply
};

void collect(const Structure& structure, const void* object, const std::string& pointer, Pointers& out) {
    for (const Field& field : structure.fields) {
        const std::string place = under(pointer, field.key);
        if (field.get) out.values.push_back(place);
        if (std::ranges::any_of(structure.fields, [&](const Field& other) { return other.only.key == field.key; }))
            out.deciders.push_back(place);
        if (!hasChildren(field)) continue;
        out.lists.push_back(place);
        const Children& children = field.children;
        for (std::size_t i = 0; i < std::min<std::size_t>(children.count(object), 8); ++i) {
            out.objects.push_back(field.kind == FieldKind::Object ? place
                                  : field.kind == FieldKind::List ? under(place, i)
                                                                  : under(place, children.name(object, i)));
            collect(children.structure(), children.item(object, i), std::string(out.objects.back()), out);
        }
    }
}

/// Random edits, mostly of the few fields that decide which others apply.
class Editor {
public:
    explicit Editor(unsigned seed) : random_(seed) {}

    Edit editOnce(const Scene& scene, std::string& did) {
        Pointers all;
        collect(sceneStructure(), &scene, "", all);
        const auto say = [&](const std::string& what, const std::string& pointer) { return did = what + " " + pointer, pointer; };
        switch (below(12)) {
            case 0: return appendAt(scene, say("append", any(all.lists)));
            case 1: return removeAt(scene, say("remove", any(all.objects)));
            case 2: return setNullAt(scene, say("null", any(all.values)));
            case 3: return resetAt(scene, say("reset", any(all.values)));
            case 4: return moveAt(scene, say("move", any(all.objects)), below(5));
            case 5: return renameAt(scene, say("rename", any(all.objects)), text());
            case 6: return copyAll(scene, scene, {say("copy", any(all.objects))}, {1.0, 0.5}, made_);
            case 7:
            case 8: return set(scene, say("set", any(all.deciders.empty() ? all.values : all.deciders)));
            default: return set(scene, say("set", any(all.values)));
        }
    }

private:
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
    const std::string& any(const std::vector<std::string>& all) { return all[below(all.size())]; }

    double number() {
        static constexpr double numbers[]{0.0, 1.0, 0.5, 2.0, 30.0, -3.25, 1e-9, 1e9, 0.1 + 0.2, 7.0, -0.0};
        return numbers[below(std::size(numbers))];
    }
    Point point() { return {number(), number()}; }
    std::string text() {
        static const std::vector<std::string> texts{"", "a", "ä 漢 №", "rebar-20", "d-bolt-20", "x/y~z", "line\nbreak \"q\" \\",
                                                    "joint", "granite", "drift", "roof", "roof.3", "max roof.3.slip"};
        return any(texts);
    }

    Edit set(const Scene& scene, const std::string& pointer) {
        const ScenePlace place = *locate(scene, pointer);
        return setValueAt(scene, pointer, valueFor(*place.field));
    }

    FieldValue valueFor(const Field& field) {
        std::vector<Point> points(2 + below(4));
        for (Point& p : points) p = point();
        switch (field.kind) {
            case FieldKind::Flag: return below(2) == 0;
            case FieldKind::Number: return number();
            case FieldKind::Integer: return static_cast<double>(below(9));
            case FieldKind::Text: return text();
            case FieldKind::Word: return std::string(field.words[below(field.words.size())]);
            case FieldKind::Vector:
            case FieldKind::Axis: return point();
            case FieldKind::PointPair: return std::vector<Point>{point(), point()};
            case FieldKind::Points: return points;
            case FieldKind::Pairs: return Table{{0.0, number()}, {number(), number()}};
            case FieldKind::Triple: return Stress{number(), number(), number()};
            case FieldKind::Place: return BoltPlace{below(2) == 0, std::abs(number())};
            case FieldKind::TextList: return std::vector<std::string>{text(), text()};
            case FieldKind::TextMap: return std::map<std::string, std::string>{{"diameter", text()}};
            default: return {};
        }
    }

    std::mt19937 random_;
    std::vector<std::string> made_;
};

/// A bolt may name a missing type, an acceleration a missing file; reading the file reports the same.
bool isNameOnly(const Problem& problem) {
    return problem.message.starts_with("there is no bolt type") ||
           problem.message.find("the file cannot be opened") != std::string::npos;
}

void expectOpensAsItself(const Scene& scene, const std::string& did) {
    const std::string text = wholeSceneText(scene);
    const SceneRescue rescue = rescueSceneText(text, "saved", KEYBLOCK_SAMPLES_DIR);
    ASSERT_TRUE(rescue.scene) << did;
    for (const Problem& problem : rescue.problems)
        ASSERT_TRUE(problem.severity != Severity::Error || isNameOnly(problem)) << did << ": " << oneLine(problem);
    ASSERT_TRUE(rescue.isWhole) << did;
    const std::string again = wholeSceneText(*rescue.scene);
    const std::size_t differ = std::ranges::mismatch(again, text).in1 - again.begin();
    ASSERT_TRUE(again == text) << did << "\nwritten: " << text.substr(differ, 200) << "\nread: " << again.substr(differ, 200);
}

TEST(Saved, SceneAfterRandomEditsReadsBackEqual) {
    Editor editor(static_cast<unsigned>(numberFrom("KEYBLOCK_SEED", 1)));
    const int edits = numberFrom("KEYBLOCK_EDITS", 40);
    int done = 0;
    for (const std::string& name : sampleNames()) {
        Scene scene = sampleScene(name);
        std::string story = name;
        for (int i = 0; i < edits; ++i) {
            std::string did;
            Edit edit = editor.editOnce(scene, did);
            if (!edit.done()) continue;
            ++done;
            story += "; " + did;
            scene = std::move(edit.scene);
            expectOpensAsItself(scene, story);
            if (HasFatalFailure()) break;
        }
    }
    EXPECT_GT(done, edits * 8);
}

TEST(Saved, ChangingTheKindResetsFieldsThatDoNotApply) {
    Scene scene = newScene();
    scene.stages[0].increments = 12;
    scene.stages[0].until.unbalanced = 1e-7;
    const Edit dynamic = setValueAt(scene, "/stages/0/kind", std::string("dynamic"));
    ASSERT_TRUE(dynamic.done()) << dynamic.refusal;
    EXPECT_FALSE(dynamic.scene.stages[0].increments);
    EXPECT_TRUE(dynamic.scene.stages[0].until == Until{});
    expectOpensAsItself(dynamic.scene, "kind");
    const Edit round = setValueAt(sampleScene("drift-bolted"), "/tunnels/0/profile", std::string("circle"));
    EXPECT_EQ(round.scene.tunnels[0].width, 0.0);
    EXPECT_EQ(round.scene.tunnels[0].center, sampleScene("drift-bolted").tunnels[0].center);
}

TEST(Saved, BoltTypesAreNotDerivedInACircle) {
    Scene scene = sampleScene("drift-bolted");
    for (const char* name : {"mine", "yours"}) {
        scene.boltTypes.push_back(*findBuiltInBoltType("rebar-20"));
        scene.boltTypes.back().name = name;
        scene.boltTypes.back().builtIn = false;
    }
    const Edit like = setValueAt(scene, "/bolt_types/yours/like", std::string("mine"));
    ASSERT_TRUE(like.done()) << like.refusal;
    EXPECT_FALSE(setValueAt(like.scene, "/bolt_types/mine/like", std::string("yours")).done());
    EXPECT_FALSE(setValueAt(like.scene, "/bolt_types/mine/like", std::string("missing")).done());
    EXPECT_TRUE(setValueAt(like.scene, "/bolt_types/mine/like", std::string("rebar-20")).done());
    Scene circle = like.scene;
    for (BoltType& type : circle.boltTypes)
        if (type.name == "mine") type.like = "yours";
    settle(circle);
    expectOpensAsItself(circle, "circle");
}

}  // namespace
