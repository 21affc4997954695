// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with a study is reported at its place, with what to do, all at once.
#include "solver/study/study_file.h"

#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

const std::filesystem::path samplesFolder = KEYBLOCK_SAMPLES_DIR;

/// Reads a study of the sample scene; `rest` are further members of the study.
StudyReading studyWith(const std::string& rest) {
    const test::ScratchFolder folder;
    std::filesystem::copy_file(samplesFolder / "bolted-incline.json", folder.path() / "scene.json");
    test::putContent(folder.path() / "study.json",
                     "{ \"format\": \"keyblock-study\", \"version\": 1, \"scene\": \"scene.json\",\n" + rest + "}\n");
    return readStudyFile(folder.path() / "study.json");
}

std::string withParameter(const std::string& parameter) {
    return "\"plan\": { \"cases\": 10 },\n\"parameters\": [ " + parameter + " ]";
}

void expectProblem(const std::string& rest, const std::string& pointer, const std::string& part) {
    const StudyReading reading = studyWith(rest);
    EXPECT_FALSE(reading.study) << rest;
    const bool found = std::ranges::any_of(reading.problems, [&](const Problem& problem) {
        return problem.severity == Severity::Error && problem.pointer == pointer && problem.line > 0 &&
               problem.message.find(part) != std::string::npos && !problem.remedy.empty();
    });
    std::string all;
    for (const Problem& problem : reading.problems) all += oneLine(problem) + "\n";
    EXPECT_TRUE(found) << rest << "\n" << pointer << ": " << part << "\n" << all;
}

TEST(StudyFile, SampleIsRead) {
    const StudyReading reading = readStudyFile(samplesFolder / "studies/bolted-incline.json");
    for (const Problem& problem : reading.problems) ADD_FAILURE() << oneLine(problem);
    ASSERT_TRUE(reading.study);
    EXPECT_EQ(reading.study->plan.cases, 1000);
    EXPECT_EQ(reading.study->parameters.front().distribution->kind, DistributionKind::Normal);
    EXPECT_EQ(reading.study->fails, "not stands");
    EXPECT_TRUE(isStudyText(reading.text));
    EXPECT_FALSE(isStudyText(reading.sceneText));
}

TEST(StudyFile, ValuesMayBeNumbersTextsAndFlags) {
    const StudyReading reading = studyWith(withParameter(R"({ "path": "bolts.B.plate", "values": ["none", "spring"] },
        { "path": "bolts[0].divisions", "values": [10, 20] },
        { "path": "analysis.model_everything", "values": [true, false] },
        { "path": "/bolt_types/tie/anchors/0/strength", "range": { "from": 1e3, "to": 5e3, "count": 5 } })"));
    for (const Problem& problem : reading.problems) ADD_FAILURE() << oneLine(problem);
    ASSERT_TRUE(reading.study);
    EXPECT_EQ(reading.study->parameters[0].values, (std::vector<std::string>{"\"none\"", "\"spring\""}));
    EXPECT_EQ(reading.study->parameters[1].values, (std::vector<std::string>{"10", "20"}));
    EXPECT_EQ(reading.study->parameters[2].values, (std::vector<std::string>{"true", "false"}));
    EXPECT_EQ(reading.study->parameters[1].name, "bolts[0].divisions");
}

TEST(StudyFile, WrongNamesAreReported) {
    expectProblem(withParameter(R"({ "path": "joint_materials.joint.frction_angle", "values": [1] })"),
                  "/parameters/0/path", "'frction_angle' is not a key there");
    expectProblem(withParameter(R"({ "path": "bolts.C.pretension", "values": [1] })"), "/parameters/0/path",
                  "there is no element 'C'");
    expectProblem(withParameter(R"({ "path": "bolts.B.pretension", "vlaues": [1] })"), "/parameters/0/vlaues",
                  "no key 'vlaues'");
    expectProblem(
        "\"plan\": { \"cases\": 10 }, \"faults\": [{ \"name\": \"m\", \"kind\": \"missing\", \"bolts\": [\"C\"] }]",
        "/faults/0/bolts/0", "there is no bolt 'C'");
    expectProblem("\"plan\": { \"cases\": 10 }, \"quantities\": [\"max kye.u\"]", "/quantities/0", "kye");
    expectProblem("\"plan\": { \"cases\": 10 }, \"fails\": \"max kye.u > 1\"", "/fails", "kye");
    expectProblem("\"plan\": { \"cases\": 10 }, \"quantities\": [\"factor_of_safety\"]", "/quantities/0",
                  "not searched for");
}

TEST(StudyFile, ImpossibleRangesAreReported) {
    const std::string path = "{ \"path\": \"joint_materials.joint.friction_angle\", ";
    expectProblem(withParameter(path + R"("distribution": { "kind": "uniform", "least": 40, "most": 30 } })"),
                  "/parameters/0/distribution/most", "not above 'least'");
    expectProblem(withParameter(path + R"("distribution": { "kind": "uniform", "least": 40, "most": 95 } })"),
                  "/parameters/0", "95 is out of range for 'friction_angle'");
    expectProblem(withParameter(path + R"("distribution": { "kind": "normal", "mean": 30, "deviation": -1 } })"),
                  "/parameters/0/distribution/deviation", "out of range");
    expectProblem(withParameter(path + R"("distribution": { "kind": "normal", "mean": 30 } })"),
                  "/parameters/0/distribution/deviation", "no 'deviation'");
    expectProblem(withParameter(path + R"("distribution": { "kind": "normal", "mean": 120, "deviation": 3 } })"),
                  "/parameters/0", "most of the distribution is out of range");
    expectProblem(withParameter(path + R"("distribution": { "kind": "lognormal", "mean": -3, "deviation": 3 } })"),
                  "/parameters/0/distribution/mean", "positive");
    expectProblem(
        withParameter(path + R"("distribution": { "kind": "triangular", "least": 20, "most": 30, "peak": 31 } })"),
        "/parameters/0/distribution/peak", "not between");
    expectProblem(withParameter(path + R"("values": [30, -5] })"), "/parameters/0", "-5 is out of range");
    expectProblem(withParameter(path + R"("values": [30], "range": { "from": 1, "to": 2, "count": 2 } })"),
                  "/parameters/0", "exactly one of");
    expectProblem(withParameter(R"({ "path": "bolts.B.divisions", "distribution": { "kind": "uniform", "least": 5,
                                    "most": 9 } })"),
                  "/parameters/0/path", "is a whole number");
    expectProblem("\"parameters\": [" + path + "\"values\": [1] }]", "/plan/cases", "no number of cases");
    expectProblem("\"plan\": { \"cases\": 0 }", "/plan/cases", "out of range");
}

TEST(StudyFile, TailsBeyondTheRangeAreAWarning) {
    const StudyReading reading = studyWith(withParameter(R"({ "path": "joint_materials.joint.friction_angle",
        "distribution": { "kind": "normal", "mean": 8, "deviation": 4 } })"));
    ASSERT_TRUE(reading.study);
    ASSERT_EQ(reading.problems.size(), 1u);
    EXPECT_NE(reading.problems[0].message.find("2.275 % of the cases"), std::string::npos)
        << reading.problems[0].message;
}

TEST(StudyFile, ASceneThatIsMissingOrBrokenIsNamed) {
    const test::ScratchFolder folder;
    const std::string study =
        R"({ "format": "keyblock-study", "version": 1, "scene": "scene.json", "plan": { "cases": 1 },
        "parameters": [ { "path": "title", "values": ["a"] } ] })";
    test::putContent(folder.path() / "study.json", study);
    StudyReading reading = readStudyFile(folder.path() / "study.json");
    ASSERT_FALSE(reading.problems.empty());
    EXPECT_EQ(reading.problems[0].pointer, "/scene");
    test::putContent(folder.path() / "scene.json", "{}");
    reading = readStudyFile(folder.path() / "study.json");
    EXPECT_FALSE(reading.study);
    EXPECT_TRUE(reading.problems.back().file.ends_with("scene.json"));
}

TEST(StudyFile, WrittenStudyIsReadBackAndKeepsItsCases) {
    const std::filesystem::path path = samplesFolder / "studies/bolted-incline.json";
    const StudyReading before = readStudyFile(path);
    const StudyReading after = readStudyText(studyText(*before.study), path);
    ASSERT_TRUE(after.study);
    EXPECT_EQ(*after.study, *before.study);
}

TEST(StudyFile, WrittenValuesOfListsKeepTheirTypes) {
    Study study;
    study.scene = "scene.json";
    study.plan.kind = PlanKind::FullFactorial;
    study.parameters.push_back({"", "bolts.B.plate", {}, {"\"none\"", "\"spring\""}, {}, {}});
    study.parameters.push_back({"", "analysis.model_everything", {}, {"true", "false"}, {}, {}});
    study.parameters.push_back({"", "bolts[0].divisions", {}, {"10", "20"}, {}, {}});
    const std::string text = studyText(study);
    EXPECT_NE(text.find("[\"none\", \"spring\"]"), std::string::npos) << text;
    EXPECT_NE(text.find("[true, false]"), std::string::npos) << text;
    EXPECT_NE(text.find("[10, 20]"), std::string::npos) << text;
    const std::string scene = test::contentOf(samplesFolder / "bolted-incline.json");
    const StudyReading reading = readStudyText(text, "study.json", &scene);
    for (const Problem& problem : reading.problems) ADD_FAILURE() << oneLine(problem);
    ASSERT_TRUE(reading.study);
    EXPECT_EQ(reading.study->parameters[1].values, study.parameters[1].values);
}

TEST(StudyFile, NumbersThatDoNotApplyAreNotWritten) {
    Study study;
    study.scene = "scene.json";
    study.plan = {PlanKind::FullFactorial, 100, 7, {}};  // a full factorial plan has no number of cases
    StudyDistribution uniform;
    uniform.mean = 3.0;
    uniform.least = 1.0;
    uniform.most = 2.0;
    study.parameters.push_back({"a", "joint_materials.joint.friction_angle", {}, {}, {}, uniform});
    const std::string text = studyText(study);
    EXPECT_EQ(text.find("\"mean\""), std::string::npos) << text;
    EXPECT_EQ(text.find("\"cases\""), std::string::npos) << text;
    EXPECT_NE(text.find("\"seed\": 7"), std::string::npos) << text;
}

TEST(StudyFile, StudyWithErrorsIsReadAsFarAsPossible) {
    const StudyReading wrong = studyWith(withParameter(R"({ "path": "no.such.field", "values": [1] })"));
    EXPECT_FALSE(wrong.study);
    ASSERT_TRUE(wrong.partly);
    EXPECT_TRUE(wrong.isWhole);
    EXPECT_EQ(wrong.partly->parameters.front().path, "no.such.field");
    const StudyReading unknown = studyWith(withParameter(R"({ "path": "gravity", "walues": [1] })"));
    ASSERT_TRUE(unknown.partly);
    EXPECT_FALSE(unknown.isWhole) << "a key that is not known would be lost in saving";
    EXPECT_FALSE(readStudyText("no JSON", "study.json").partly);
}

}  // namespace
}  // namespace keyblock
